// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/FiniteElements/StiffnessAssembly.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <limits>

namespace palpate
{
namespace
{
int numberUnknowns(const VolumeMesh& mesh, const MeshTopology& topology,
  const std::vector<unsigned char>& fixed, std::vector<int>& dof)
{
  dof.assign(3 * static_cast<std::size_t>(mesh.nodeTotal()), -1);
  int next = 0;
  for (std::int32_t i = 0; i < mesh.nodeTotal(); ++i)
  {
    if (topology.elementsBegin(i) == topology.elementsEnd(i))
    {
      continue;
    }
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      if ((fixed[static_cast<std::size_t>(i)] >> axis & 1U) == 0)
      {
        dof[3 * static_cast<std::size_t>(i) + axis] = next++;
      }
    }
  }
  return next;
}

/// Finds the node itself and all later nodes that share an element with it, in ascending order.
void laterNeighbours(const VolumeMesh& mesh, const MeshTopology& topology, std::int32_t node,
  std::vector<std::int32_t>& neighbours)
{
  neighbours.clear();
  for (const std::int32_t* e = topology.elementsBegin(node); e != topology.elementsEnd(node); ++e)
  {
    const VolumeElement& element = mesh.elements[static_cast<std::size_t>(*e)];
    for (int i = 0; i < nodeCount(element.kind); ++i)
    {
      const std::int32_t other = element.nodes[static_cast<std::size_t>(i)];
      if (other >= node)
      {
        neighbours.push_back(other);
      }
    }
  }
  std::sort(neighbours.begin(), neighbours.end());
  neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
}

/// Allocates the pattern of the lower triangle and fills it with zeros. Returns false if the number
/// of entries exceeds the range of int.
bool layOut(const VolumeMesh& mesh, const MeshTopology& topology, const std::vector<int>& dof,
  int unknowns, SymmetricSparse& lower)
{
  std::vector<int> starts(static_cast<std::size_t>(unknowns) + 1, 0);
  std::vector<int> rows;
  std::vector<std::int32_t> neighbours;
  for (std::int32_t node = 0; node < mesh.nodeTotal(); ++node)
  {
    if (topology.elementsBegin(node) == topology.elementsEnd(node))
    {
      continue;
    }
    laterNeighbours(mesh, topology, node, neighbours);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const int column = dof[3 * static_cast<std::size_t>(node) + axis];
      if (column < 0)
      {
        continue;
      }
      for (const std::int32_t other : neighbours)
      {
        for (std::size_t k = 0; k < 3; ++k)
        {
          const int row = dof[3 * static_cast<std::size_t>(other) + k];
          if (row >= column)
          {
            rows.push_back(row);
          }
        }
      }
      if (rows.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
      {
        return false;
      }
      starts[static_cast<std::size_t>(column) + 1] = static_cast<int>(rows.size());
    }
  }
  lower.resize(unknowns, unknowns);
  lower.resizeNonZeros(static_cast<Eigen::Index>(rows.size()));
  std::copy(starts.begin(), starts.end(), lower.outerIndexPtr());
  std::copy(rows.begin(), rows.end(), lower.innerIndexPtr());
  std::fill_n(lower.valuePtr(), rows.size(), 0.0);
  return true;
}

/// One part of the body, with its first element and the constraints on its rigid motions.
struct Part
{
  std::int32_t firstElement = -1;
  int elements = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double nodes = 0.0;
  double size = 0.0;
  Eigen::Matrix<double, 6, 6> stopped = Eigen::Matrix<double, 6, 6>::Zero();
};
} // namespace

void addElement(const VolumeElement& element, const ElementMatrix& k, StiffnessMatrix& stiffness)
{
  const int* starts = stiffness.lower.outerIndexPtr();
  const int* rows = stiffness.lower.innerIndexPtr();
  double* values = stiffness.lower.valuePtr();
  const auto unknown = [&](int i)
  {
    return stiffness
      .dof[3 * static_cast<std::size_t>(element.nodes[static_cast<std::size_t>(i / 3)]) +
        static_cast<std::size_t>(i % 3)];
  };
  for (int j = 0; j < k.cols(); ++j)
  {
    const int column = unknown(j);
    if (column < 0)
    {
      continue;
    }
    const int* first = rows + starts[column];
    const int* last = rows + starts[column + 1];
    for (int i = 0; i < k.rows(); ++i)
    {
      const int row = unknown(i);
      if (row >= column)
      {
        values[std::lower_bound(first, last, row) - rows] += k(i, j);
      }
    }
  }
}

std::string assembleStiffness(const VolumeMesh& mesh, const MeshTopology& topology,
  const std::vector<ElasticMaterial>& materials, const std::vector<unsigned char>& fixed,
  StiffnessMatrix& stiffness)
{
  const int unknowns = numberUnknowns(mesh, topology, fixed, stiffness.dof);
  if (!layOut(mesh, topology, stiffness.dof, unknowns, stiffness.lower))
  {
    return "the stiffness matrix of " + std::to_string(unknowns) +
      " unknowns has more than 2^31 entries, which cannot be solved";
  }
  ElementMatrix k;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
  {
    const VolumeElement& element = mesh.elements[e];
    const ElasticMaterial& material = materials[materials.size() == 1 ? 0 : e];
    if (!elementStiffness(element.kind, elementNodes(mesh, element), material, k))
    {
      return "cell " + std::to_string(e) +
        " is inverted or has no volume: its Jacobian is not positive";
    }
    addElement(element, k, stiffness);
  }
  return {};
}

std::string findFloatingPart(
  const VolumeMesh& mesh, const MeshTopology& topology, const std::vector<unsigned char>& fixed)
{
  const std::vector<std::int32_t> partNumber = partOfNodes(mesh);
  std::vector<Part> parts(static_cast<std::size_t>(mesh.nodeTotal()));
  const auto partOf = [&](std::int32_t node) -> Part&
  { return parts[static_cast<std::size_t>(partNumber[static_cast<std::size_t>(node)])]; };
  for (std::int32_t e = 0; e < mesh.elementTotal(); ++e)
  {
    Part& part = partOf(mesh.elements[static_cast<std::size_t>(e)].nodes[0]);
    part.firstElement = part.firstElement < 0 ? e : part.firstElement;
    ++part.elements;
  }
  const auto inBody = [&topology](std::int32_t node)
  { return topology.elementsBegin(node) != topology.elementsEnd(node); };
  for (std::int32_t i = 0; i < mesh.nodeTotal(); ++i)
  {
    if (inBody(i))
    {
      partOf(i).centre += mesh.nodes.col(i);
      partOf(i).nodes += 1.0;
    }
  }
  for (std::int32_t i = 0; i < mesh.nodeTotal(); ++i)
  {
    if (inBody(i))
    {
      Part& part = partOf(i);
      part.size = std::max(part.size, (mesh.nodes.col(i) - part.centre / part.nodes).norm());
    }
  }
  for (std::int32_t i = 0; i < mesh.nodeTotal(); ++i)
  {
    if (!inBody(i))
    {
      continue;
    }
    Part& part = partOf(i);
    const Eigen::Vector3d x = (mesh.nodes.col(i) - part.centre / part.nodes) / part.size;
    Eigen::Matrix<double, 3, 6> motion; // columns: three translations, three rotations
    motion << 1, 0, 0, 0, x[2], -x[1], 0, 1, 0, -x[2], 0, x[0], 0, 0, 1, x[1], -x[0], 0;
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      if ((fixed[static_cast<std::size_t>(i)] >> axis & 1U) != 0)
      {
        part.stopped += motion.row(axis).transpose() * motion.row(axis);
      }
    }
  }
  for (std::int32_t e = 0; e < mesh.elementTotal(); ++e)
  {
    const Part& part = partOf(mesh.elements[static_cast<std::size_t>(e)].nodes[0]);
    if (part.firstElement != e)
    {
      continue;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> spectrum(part.stopped);
    // A rigid motion counts as free if it is prevented only by nodes whose distance from its axis
    // is below 1e-5 of the part's size.
    const double floor = std::max(1e-10 * spectrum.eigenvalues()[5], 1e-10);
    const auto left = (spectrum.eigenvalues().array() < floor).count();
    if (left > 0)
    {
      return "the part of " + std::to_string(part.elements) + " cells that contains cell " +
        std::to_string(e) + " is floating: its fixed points leave " + std::to_string(left) +
        " of 6 rigid motions free";
    }
  }
  return {};
}
} // namespace palpate
