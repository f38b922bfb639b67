// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/ToolFacets.h"

#include "Solids/FiniteElements/PatchLoad.h"
#include "Mechanics/Numerics/Constants.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>

namespace palpate
{
namespace
{
/// Largest distance from the tool at its largest depth of a facet that may touch, as a fraction of
/// the depth.
constexpr double TouchMargin = 0.1;
/// Smallest cosine of the angle between the tool's axis and the normal of a facet that may touch.
constexpr double LeastFacing = 0.1;
constexpr double NearWall = 0.995;
constexpr double NearTool = 1.1;

ToolFacet facetOf(const VolumeMesh& mesh, const BoundaryFace& boundary, const DirectPlace& at,
  const Eigen::Matrix3d& frame)
{
  const VolumeElement& element = mesh.elements[static_cast<std::size_t>(boundary.element)];
  const ElementFace& face = elementFace(element.kind, boundary.face);
  ToolFacet made;
  made.corners = face.corners;
  made.places.resize(3, face.nodes);
  for (int i = 0; i < face.nodes; ++i)
  {
    const auto node = static_cast<std::size_t>(face.node[static_cast<std::size_t>(i)]);
    made.nodes.push_back(element.nodes[node]);
    made.places.col(i) = frame.transpose() * (mesh.nodes.col(made.nodes.back()) - at.place);
  }
  const Eigen::Vector3d along = made.places.col(1) - made.places.col(0);
  const Eigen::Vector3d across = made.places.col(made.corners - 1) - made.places.col(0);
  made.area = along.cross(across) * (made.corners == 3 ? 0.5 : 1.0);
  return made;
}

bool mayTouch(const ToolFacet& facet, const AxisymmetricTool& tool, double deepest)
{
  const double wall = tool.largestContactRadius();
  bool isIn = false;
  for (Eigen::Index i = 0; i < facet.places.cols(); ++i)
  {
    const double r = facet.places.col(i).head<2>().norm();
    const double reached = deepest - tool.profile(std::min(r, NearWall * wall));
    isIn = isIn || (r < NearTool * wall && facet.places(2, i) < reached + TouchMargin * deepest);
  }
  return isIn && -facet.area[2] > LeastFacing * facet.area.norm();
}
} // namespace

Eigen::Matrix3d toolFrame(const DirectPlace& at)
{
  return tangentFrame(-at.inward);
}

double reachedRadius(const AxisymmetricTool& tool)
{
  return (tool.smallestContactRadius() > 0.0 ? 1.0 : NearWall) * tool.largestContactRadius();
}

std::vector<ToolFacet> facetsUnder(
  const ElasticBody& body, const AxisymmetricTool& tool, const DirectPlace& at, double deepest)
{
  const Eigen::Matrix3d frame = toolFrame(at);
  std::vector<ToolFacet> facets;
  std::map<std::int32_t, std::vector<std::size_t>> around;
  double nearest = Infinity;
  std::size_t first = 0;
  for (const BoundaryFace& boundary : body.topology().boundary())
  {
    ToolFacet facet = facetOf(body.mesh(), boundary, at, frame);
    if (!mayTouch(facet, tool, deepest))
    {
      continue;
    }
    for (int i = 0; i < facet.corners; ++i)
    {
      around[facet.nodes[static_cast<std::size_t>(i)]].push_back(facets.size());
      const double away = facet.places.col(i).norm();
      first = away < nearest ? facets.size() : first;
      nearest = std::min(nearest, away);
    }
    facets.push_back(std::move(facet));
  }
  std::vector<bool> isTaken(facets.size(), false);
  std::vector<std::size_t> taken;
  const auto take = [&](std::size_t next)
  {
    if (!isTaken[next])
    {
      isTaken[next] = true;
      taken.push_back(next);
    }
  };
  if (!facets.empty())
  {
    take(first);
  }
  std::vector<ToolFacet> near;
  for (std::size_t i = 0; i < taken.size(); ++i)
  {
    near.push_back(std::move(facets[taken[i]]));
    for (int k = 0; k < near.back().corners; ++k)
    {
      const auto& beside = around[near.back().nodes[static_cast<std::size_t>(k)]];
      std::for_each(beside.begin(), beside.end(), take);
    }
  }
  return near;
}

double depthOfMarked(const std::vector<ToolFacet>& facets, const std::vector<unsigned char>& marked,
  const AxisymmetricTool& tool)
{
  const double wall = reachedRadius(tool);
  double least = Infinity;
  for (const ToolFacet& facet : facets)
  {
    const bool isMarked = std::all_of(facet.nodes.begin(), facet.nodes.end(),
      [&](std::int32_t node) { return marked[static_cast<std::size_t>(node)] != 0; });
    for (Eigen::Index i = 0; i < facet.places.cols() && isMarked; ++i)
    {
      const double r = facet.places.col(i).head<2>().norm();
      least = r < wall ? std::min(least, facet.places(2, i) + tool.profile(r)) : least;
    }
  }
  return least;
}
} // namespace palpate
