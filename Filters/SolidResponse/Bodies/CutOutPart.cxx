// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/CutOutPart.h"

#include "Response/BodyConversion.h"
#include "SolidResponse/Mesher/MeshConversion.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
constexpr double InteriorRatio = 4.0;
constexpr double Growth = 0.5;
/// Largest deviation of facets from the surface, as a fraction of the spacing of the cells away
/// from the tool. Fine cells under the tool follow the surface more closely. A smaller value would
/// need many cells at the edges of the box.
constexpr double DeviationRatio = 0.15;
/// Largest distance from a side of the box, as a fraction of the spacing, at which a node counts as
/// on the cut. Cells do not follow the edges of the box, because this would need many cells.
constexpr double NearSide = 0.1;
/// Edge length of a cube with the smallest volume that is kept, relative to half the side of the
/// box.
constexpr double LeastPart = 0.02;
constexpr double ExpectedCells = 1e4; ///< used only to detect a surface that is too rough

/// Returns the sides of a box that cut off a part of the surface. The side that leaves the smallest
/// part of the surface is first.
std::vector<CutPlane> sidesOf(const MeshedSurface& body, const Eigen::Vector3d& place, double half)
{
  std::vector<CutPlane> planes;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    const double low = place[axis] - half;
    const double high = place[axis] + half;
    if (body.points.row(axis).minCoeff() < low)
    {
      planes.push_back({ axis, false, low });
    }
    if (body.points.row(axis).maxCoeff() > high)
    {
      planes.push_back({ axis, true, high });
    }
  }
  const auto left = [&](const CutPlane& plane)
  {
    const auto row = body.points.row(plane.axis).array();
    return plane.isUpper ? (row < plane.at).count() : (row > plane.at).count();
  };
  std::vector<std::pair<Eigen::Index, CutPlane>> byLeft;
  for (const CutPlane& plane : planes)
  {
    byLeft.emplace_back(left(plane), plane);
  }
  std::stable_sort(
    byLeft.begin(), byLeft.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::transform(
    byLeft.begin(), byLeft.end(), planes.begin(), [](const auto& each) { return each.second; });
  return planes;
}

void takeCells(
  const CurvedTetrahedra& curved, const CutOutSurface& from, double near, CutOutPart& part)
{
  part.mesh.nodes = curved.nodes;
  part.mesh.elements.clear();
  for (const auto& cell : curved.cells)
  {
    VolumeElement element;
    element.kind = ElementKind::QuadraticTetrahedron;
    std::copy(cell.begin(), cell.end(), element.nodes.begin());
    part.mesh.elements.push_back(element);
  }
  part.onCut.clear();
  part.held.clear();
  for (Eigen::Index i = 0; i < curved.nodes.cols(); ++i)
  {
    const auto beyond = [&](const CutPlane& plane)
    { return (curved.nodes(plane.axis, i) - plane.at) * (plane.isUpper ? 1.0 : -1.0); };
    const bool isHeld = std::any_of(from.surface.held.begin(), from.surface.held.end(),
      [&](const CutPlane& plane) { return beyond(plane) >= 0.0; });
    const bool isOnCut = std::any_of(from.sides.begin(), from.sides.end(),
      [&](const CutPlane& plane) { return beyond(plane) > -near; });
    part.held.push_back(isHeld);
    part.onCut.push_back(isOnCut && !isHeld);
  }
}

/// Keeps only elements that are connected, face by face, to a face that is held or on the cut. This
/// removes fragments of thin flaps at the cut. It also removes parts that are connected only by an
/// edge, because they could rotate about the edge. Returns "" or an error message.
std::string removeLoose(CutOutPart& part)
{
  MeshTopology topology;
  std::string fault = topology.build(part.mesh);
  if (!fault.empty())
  {
    return fault;
  }
  std::vector<unsigned char> fixed(part.onCut.size());
  std::transform(part.onCut.begin(), part.onCut.end(), part.held.begin(), fixed.begin(),
    [](unsigned char cut, unsigned char held)
    { return static_cast<unsigned char>(cut != 0 || held != 0); });
  std::vector<VolumeElement> kept;
  for (const std::int32_t e : elementsHeldByFaces(part.mesh, topology, fixed))
  {
    kept.push_back(part.mesh.elements[static_cast<std::size_t>(e)]);
  }
  part.mesh.elements = std::move(kept);
  return part.mesh.elements.empty() ? "nothing holds it" : "";
}

/// Removes all rims except those of the held part, so that cells follow only these rims.
void keepHeldRims(PreparedSurface& surface)
{
  MeshedSurface& wanted = surface.wanted;
  const auto isOfSide = [&](const std::array<std::int32_t, 2>& rim)
  {
    return std::none_of(surface.cuts.begin(), surface.cuts.end(),
      [&](const CutPlane& plane)
      {
        return wanted.points(plane.axis, rim[0]) == plane.at &&
          wanted.points(plane.axis, rim[1]) == plane.at;
      });
  };
  wanted.rims.erase(
    std::remove_if(wanted.rims.begin(), wanted.rims.end(), isOfSide), wanted.rims.end());
}
} // namespace

std::string cutOutAround(
  const PreparedSurface& body, const Eigen::Vector3d& place, double half, CutOutSurface& part)
{
  part.sides = sidesOf(body.wanted, place, half);
  PreparedSurface& surface = part.surface;
  surface = {};
  surface.wanted = body.wanted;
  surface.cuts = body.cuts;
  surface.held = body.held;
  const std::string fault =
    cutOff(surface.wanted, part.sides, std::pow(LeastPart * half, 3), body.cuts);
  if (fault.empty())
  {
    keepHeldRims(surface);
    surface.closed.surface = convertMeshToSurface(surface.wanted);
    surface.closed.volume = makeBodyMesh(surface.closed.surface).enclosedVolume();
  }
  return fault;
}

std::string fillPart(const CutOutSurface& part, const PartCells& cells, CutOutPart& filled)
{
  PreparedSurface own = part.surface;
  MeshedSurface& wanted = own.wanted;
  wanted.spacing.assign(static_cast<std::size_t>(wanted.points.cols()), cells.spacing);
  wanted.balls = cells.balls;
  wanted.interiorSpacing = InteriorRatio * cells.spacing;
  wanted.growth = Growth;
  wanted.deviation = DeviationRatio * cells.spacing;
  // This has no effect at the tool, which is far from the affected places.
  wanted.isManifold = false;
  CurvedTetrahedra curved;
  const std::string fault = fillPrepared(own, cells.spacing, ExpectedCells, {}, curved);
  if (!fault.empty())
  {
    return fault;
  }
  if (curved.cells.empty())
  {
    return "it has no cells";
  }
  takeCells(curved, part, NearSide * cells.spacing, filled);
  return removeLoose(filled);
}
} // namespace palpate
