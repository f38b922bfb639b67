// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/FiniteElements/PatchSelfTerm.h"

#include "Mechanics/Numerics/Constants.h"
#include "Solids/FiniteElements/HalfSpaceField.h"
#include "Solids/FiniteElements/StiffnessAssembly.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>

namespace palpate
{
namespace
{
using TwoColumns = Eigen::Matrix<double, Eigen::Dynamic, 2>;

std::size_t nodeOf(const VolumeElement& element, int i)
{
  return static_cast<std::size_t>(element.nodes[static_cast<std::size_t>(i)]);
}

/// Returns the motion of the half-space under the two loads (3 rows per node), at the prescribed
/// nodes.
TwoColumns halfSpaceMotion(const LocalPatch& patch)
{
  TwoColumns motion = TwoColumns::Zero(3 * patch.mesh.nodes.cols(), 2);
  const DiscRule& rule = DiscRule::standard();
  for (Eigen::Index i = 0; i < patch.mesh.nodes.cols(); ++i)
  {
    const auto at = static_cast<std::size_t>(i);
    if (patch.nodes[0][at] != CutNode::Prescribed && patch.nodes[1][at] != CutNode::Prescribed)
    {
      continue;
    }
    for (std::size_t k = 0; k < 2; ++k)
    {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (std::size_t q = 0; q < DiscRule::Count; ++q)
      {
        sum += rule.weights[q] *
          boussinesqDisplacement(
            patch.mesh.nodes.col(i) - patch.loads[k].places[q], patch.poissonRatio);
      }
      motion.block<3, 1>(3 * i, static_cast<Eigen::Index>(k)) = sum;
    }
  }
  return motion;
}

/// Returns the free nodes of a cut in an order of elimination with little fill-in (minimum degree).
std::vector<std::int32_t> orderNodes(const LocalPatch& patch, const std::vector<CutNode>& marks)
{
  std::vector<std::int32_t> free;
  std::vector<int> number(marks.size(), -1);
  for (std::size_t i = 0; i < marks.size(); ++i)
  {
    if (marks[i] == CutNode::Free)
    {
      number[i] = static_cast<int>(free.size());
      free.push_back(static_cast<std::int32_t>(i));
    }
  }
  std::vector<Eigen::Triplet<double, int>> pairs;
  for (const VolumeElement& element : patch.mesh.elements)
  {
    for (int a = 0; a < nodeCount(element.kind); ++a)
    {
      for (int b = 0; b < nodeCount(element.kind); ++b)
      {
        if (number[nodeOf(element, a)] >= 0 && number[nodeOf(element, b)] >= 0)
        {
          pairs.emplace_back(number[nodeOf(element, a)], number[nodeOf(element, b)], 1.0);
        }
      }
    }
  }
  const auto count = static_cast<int>(free.size());
  SymmetricSparse graph(count, count);
  graph.setFromTriplets(pairs.begin(), pairs.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(graph, order);
  std::vector<std::int32_t> ordered(free.size());
  for (int i = 0; i < count; ++i)
  {
    ordered[static_cast<std::size_t>(i)] = free[static_cast<std::size_t>(order.indices()[i])];
  }
  return ordered;
}

/// Returns the motion of one cut under the two loads. Prescribed nodes have the motion of the
/// half-space. The result is NaN if the stiffness of the cut is singular.
TwoColumns solveCut(const LocalPatch& patch, std::size_t cut,
  const std::vector<ElementMatrix>& stiffness, const TwoColumns& motion)
{
  const std::vector<CutNode>& marks = patch.nodes[cut];
  std::vector<int> dof(3 * marks.size(), -1);
  int unknowns = 0;
  for (const std::int32_t node : orderNodes(patch, marks))
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      dof[3 * static_cast<std::size_t>(node) + axis] = unknowns++;
    }
  }
  TwoColumns right = TwoColumns::Zero(unknowns, 2);
  std::vector<Eigen::Triplet<double, int>> entries;
  for (std::size_t e = 0; e < patch.mesh.elements.size(); ++e)
  {
    if (cut == 0 && !patch.inner[e])
    {
      continue;
    }
    const VolumeElement& element = patch.mesh.elements[e];
    const ElementMatrix& k = stiffness[e];
    for (int j = 0; j < k.cols(); ++j)
    {
      const std::size_t from = 3 * nodeOf(element, j / 3) + static_cast<std::size_t>(j % 3);
      for (int i = 0; i < k.rows(); ++i)
      {
        const int row = dof[3 * nodeOf(element, i / 3) + static_cast<std::size_t>(i % 3)];
        if (row >= 0 && dof[from] < 0)
        {
          right.row(row) -= k(i, j) * motion.row(static_cast<Eigen::Index>(from));
        }
        else if (row >= 0 && row >= dof[from])
        {
          entries.emplace_back(row, dof[from], k(i, j));
        }
      }
    }
  }
  for (std::size_t k = 0; k < 2; ++k)
  {
    for (const auto& [node, weight] : patch.loads[k].nodes)
    {
      const int row = dof[3 * static_cast<std::size_t>(node) + 2];
      if (row >= 0)
      {
        right(row, static_cast<Eigen::Index>(k)) += weight;
      }
    }
  }
  SymmetricSparse lower(unknowns, unknowns);
  lower.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLLT<SymmetricSparse, Eigen::Lower, Eigen::NaturalOrdering<int>> solver(
    lower);
  if (solver.info() != Eigen::Success)
  {
    return TwoColumns::Constant(motion.rows(), 2, NotANumber);
  }
  const TwoColumns solution = solver.solve(right);
  TwoColumns moved = motion;
  for (std::size_t at = 0; at < dof.size(); ++at)
  {
    if (dof[at] >= 0)
    {
      moved.row(static_cast<Eigen::Index>(at)) = solution.row(dof[at]);
    }
  }
  return moved;
}

/// Computes the stiffness of all elements. Returns false if flattening has inverted an element.
bool stiffnessOf(const LocalPatch& patch, std::vector<ElementMatrix>& stiffness)
{
  stiffness.resize(patch.mesh.elements.size());
  for (std::size_t e = 0; e < stiffness.size(); ++e)
  {
    const VolumeElement& element = patch.mesh.elements[e];
    if (!elementStiffness(element.kind, elementNodes(patch.mesh, element),
          { 1.0, patch.poissonRatio }, stiffness[e]))
    {
      return false;
    }
  }
  return true;
}
} // namespace

SelfTerms patchSelfTerms(const LocalPatch& patch)
{
  SelfTerms terms = { { { NotANumber, NotANumber }, { NotANumber, NotANumber } } };
  std::vector<ElementMatrix> stiffness;
  if (!stiffnessOf(patch, stiffness))
  {
    return terms;
  }
  const TwoColumns motion = halfSpaceMotion(patch);
  for (std::size_t cut = 0; cut < 2; ++cut)
  {
    const TwoColumns moved = solveCut(patch, cut, stiffness, motion);
    for (std::size_t k = 0; k < 2; ++k)
    {
      terms[cut][k] = 0.0;
      for (const auto& [node, weight] : patch.loads[k].nodes)
      {
        terms[cut][k] +=
          weight * moved(3 * static_cast<Eigen::Index>(node) + 2, static_cast<Eigen::Index>(k));
      }
    }
  }
  return terms;
}

std::array<Eigen::Matrix3Xd, 2> patchMotions(const LocalPatch& patch)
{
  const Eigen::Index nodes = patch.mesh.nodes.cols();
  std::array<Eigen::Matrix3Xd, 2> motions;
  motions.fill(Eigen::Matrix3Xd::Constant(3, nodes, NotANumber));
  std::vector<ElementMatrix> stiffness;
  if (stiffnessOf(patch, stiffness))
  {
    const TwoColumns moved = solveCut(patch, 1, stiffness, halfSpaceMotion(patch));
    for (std::size_t k = 0; k < 2; ++k)
    {
      motions[k] = moved.col(static_cast<Eigen::Index>(k)).reshaped(3, nodes);
    }
  }
  return motions;
}
} // namespace palpate
