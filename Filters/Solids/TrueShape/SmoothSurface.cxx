// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/SmoothSurface.h"

#include "Solids/FiniteElements/PatchLoad.h"

#include <algorithm>

namespace palpate
{
namespace
{
/// A node counts as being on its chord if its distance from the chord is less than this fraction of
/// the lift.
constexpr double ChordTolerance = 0.25;
} // namespace

Eigen::Vector3d smoothPosition(const ElasticBody& body, std::int32_t point)
{
  const BodySurface& surface = body.surface();
  const Eigen::Vector3d& at = surface.position(point);
  const std::int32_t node = surface.node(point);
  const VolumeElement& cell =
    body.mesh().elements[static_cast<std::size_t>(*body.topology().elementsBegin(node))];
  const int local =
    static_cast<int>(std::find(cell.nodes.begin(), cell.nodes.end(), node) - cell.nodes.begin());
  if (cell.kind != ElementKind::QuadraticTetrahedron || local < 4)
  {
    return at;
  }
  const std::array<int, 2> ends = edgeOfMiddle(local);
  const std::int32_t a = surface.pointOfNode(cell.nodes[static_cast<std::size_t>(ends[0])]);
  const std::int32_t b = surface.pointOfNode(cell.nodes[static_cast<std::size_t>(ends[1])]);
  if (surface.normal(a).dot(surface.normal(b)) < PatchTurn)
  {
    return at; // the edge between the two corners is sharp
  }
  const Eigen::Vector3d edge = surface.position(b) - surface.position(a);
  const Eigen::Vector3d lift = 0.125 *
    (surface.normal(b).dot(edge) * surface.normal(b) -
      surface.normal(a).dot(edge) * surface.normal(a));
  const Eigen::Vector3d chord = 0.5 * (surface.position(a) + surface.position(b));
  return (at - chord).norm() < ChordTolerance * lift.norm() ? Eigen::Vector3d(chord + lift) : at;
}
} // namespace palpate
