// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/FiniteElements/UnitLoads.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <vector>

namespace palpate
{
namespace
{
/// Returns loads on the unknowns, one column for each force and moment about the position `place`.
/// The shape functions of the element distribute a force to its nodes. A moment M is distributed as
/// half of M × the gradients of the shape functions.
Eigen::MatrixXd unitLoads(
  const ElasticBody& body, const Eigen::Vector3d& place, const ElementPlace& beside)
{
  const VolumeElement& element = body.mesh().elements[static_cast<std::size_t>(beside.element)];
  const ElementNodes nodes = elementNodes(body.mesh(), element);
  const ElementShapes shapes = elementShapes(element.kind, beside.xi);
  ElementGradients gradients;
  elementGradients(element.kind, nodes, beside.xi, gradients);
  const Eigen::Vector3d at = nodes * shapes;
  Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(body.unknowns(), 6);
  for (int k = 0; k < 6; ++k)
  {
    const Eigen::Vector3d unit = Eigen::Vector3d::Unit(k % 3);
    const Eigen::Vector3d force = k < 3 ? unit : Eigen::Vector3d(Eigen::Vector3d::Zero());
    const Eigen::Vector3d moment = k < 3 ? Eigen::Vector3d((place - at).cross(unit)) : unit;
    for (int n = 0; n < nodeCount(element.kind); ++n)
    {
      const Eigen::Vector3d gradient = gradients.col(n);
      const Eigen::Vector3d load = shapes[n] * force + 0.5 * moment.cross(gradient);
      for (int axis = 0; axis < 3; ++axis)
      {
        const int unknown = body.unknown(element.nodes[static_cast<std::size_t>(n)], axis);
        if (unknown >= 0)
        {
          loads(unknown, k) = load[axis];
        }
      }
    }
  }
  return loads;
}

/// Copies the solutions to the free directions of the nodes. Held directions keep their values.
void spread(const ElasticBody& body, const Eigen::MatrixXd& solved, UnitMotion& motion)
{
  const auto nodes = static_cast<std::int32_t>(body.mesh().nodes.cols());
  for (int k = 0; k < 6; ++k)
  {
    Eigen::Matrix3Xd& moved = motion.nodes[static_cast<std::size_t>(k)];
    moved.conservativeResize(3, nodes);
    for (std::int32_t node = 0; node < nodes; ++node)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const int unknown = body.unknown(node, axis);
        if (unknown >= 0)
        {
          moved(axis, node) = solved(unknown, k);
        }
      }
    }
  }
}
} // namespace

UnitMotion unitMotion(
  const ElasticBody& body, const Eigen::Vector3d& place, const ElementPlace& beside)
{
  UnitMotion motion;
  motion.about = place;
  const Eigen::MatrixXd solved = body.factor().solveAll(unitLoads(body, place, beside));
  if (solved.size() > 0)
  {
    for (Eigen::Matrix3Xd& moved : motion.nodes)
    {
      moved.setZero(3, body.mesh().nodes.cols());
    }
    spread(body, solved, motion);
  }
  return motion;
}

UnitMotion motionFromCut(const ElasticBody& part, UnitMotion cut)
{
  const VolumeMesh& mesh = part.mesh();
  Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(part.unknowns(), 6);
  for (std::int32_t e = 0; e < mesh.elementTotal(); ++e)
  {
    const VolumeElement& element = mesh.elements[static_cast<std::size_t>(e)];
    const int count = nodeCount(element.kind);
    const auto* const first = element.nodes.begin();
    if (std::none_of(first, first + count, [&](std::int32_t node) { return part.isHeld(node); }))
    {
      continue;
    }
    Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(3 * count, 6);
    for (int i = 0; i < count; ++i)
    {
      const std::int32_t node = element.nodes[static_cast<std::size_t>(i)];
      for (std::size_t k = 0; k < 6 && part.isHeld(node); ++k)
      {
        moved.block<3, 1>(3 * i, static_cast<Eigen::Index>(k)) = cut.nodes[k].col(node);
      }
    }
    ElementMatrix stiffness;
    elementStiffness(element.kind, elementNodes(mesh, element), part.material(e), stiffness);
    const Eigen::MatrixXd forces = stiffness * moved;
    for (int i = 0; i < 3 * count; ++i)
    {
      const int unknown = part.unknown(element.nodes[static_cast<std::size_t>(i / 3)], i % 3);
      if (unknown >= 0)
      {
        loads.row(unknown) -= forces.row(i);
      }
    }
  }
  const Eigen::MatrixXd solved = part.factor().solveAll(loads);
  if (solved.size() == 0)
  {
    return {};
  }
  spread(part, solved, cut);
  return cut;
}
} // namespace palpate
