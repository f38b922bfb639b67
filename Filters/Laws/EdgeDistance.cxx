// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/EdgeDistance.h"

#include "Laws/EdgeSurface.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Numerics/SegmentDistance.h"
#include "Mechanics/SharedWork.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace palpate
{
namespace
{
using Eigen::Vector3d;
// Poisson's ratio for which the effects of edges are compared.
constexpr double IncompressibleRatio = 0.5;
// Sharpness of an edge of 60°. The search distance of edges of smaller sharpness is reduced in
// proportion.
constexpr double BluntSharpness = 0.2;
// Sine of the largest angle between the direction to an edge and the tangent plane.
constexpr double LargestRise = 0.25;
// Largest distance of edges found with one cell size, in cells.
constexpr double LargestCellDistance = 4.0;
constexpr double CellRatio = 3.0; // ratio of one cell size to the next smaller one
// Largest size of a cell as a fraction of the body's width. Larger cells do not resolve the shape
// of the body.
constexpr double LargestCell = 0.25;

double sharpnessOf(float turn)
{
  return edgeSharpness(IncompressibleRatio, static_cast<double>(turn));
}

double distanceTo(const Vector3d& point, const Vector3d& from, const Vector3d& to)
{
  return std::sqrt(squareToSegment(Vector3d(from - point), Vector3d(to - point)));
}

/// Returns the contact radii (mm) for which edges are searched, from the finest to the coarsest
/// cells.
std::vector<double> cellRadii(const EdgeSurface& surface, double contactRadius, double reach)
{
  std::vector<double> radii{ contactRadius };
  for (;;)
  {
    const double cell = edgeCell(surface, radii.back());
    const double next = CellRatio * cell;
    if (LargestCellDistance * cell >= reach || next > LargestCell * surface.width)
    {
      return radii;
    }
    radii.push_back(next);
  }
}

/// Propagates edge sides outwards over the surface. Each point passes its nearest side on to its
/// neighbours.
class SideSpread
{
public:
  explicit SideSpread(const EdgeSurface& surface)
    : Surface(surface)
  {
  }

  /// Calls `take(point, side, distance)` for each point that has at least one of `sides` within
  /// `reach` (mm). `side` is the nearest side that does not rise above the point's tangent plane.
  template <class Take>
  void from(const std::vector<SurfaceSide>& sides, double reach, const Take& take) const
  {
    if (sides.empty())
    {
      return;
    }
    // The pair (distance, (point, side)).
    using Entry = std::pair<float, std::pair<std::int32_t, std::int32_t>>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
    std::vector<float> distances(this->Surface.spans.pointCount, NearEdge::Far);
    // `reached` is the distance of the front, mm. Points at a smaller distance already have their
    // final side.
    const auto offer = [&](std::int32_t point, std::int32_t side, float reached)
    {
      const auto i = static_cast<std::size_t>(point);
      if (distances[i] <= reached)
      {
        return;
      }
      const SurfaceSide& edge = sides[static_cast<std::size_t>(side)];
      const Vector3d here = this->Surface.place(point);
      const Vector3d one = this->Surface.place(edge.from);
      const Vector3d other = this->Surface.place(edge.to);
      const auto away = static_cast<float>(distanceTo(here, one, other));
      const double rise = (0.5 * (one + other) - here).dot(this->Surface.normals[i]);
      if (away < distances[i] && static_cast<double>(away) <= reach &&
        rise <= LargestRise * static_cast<double>(away) + 1e-9)
      {
        distances[i] = away;
        front.push({ away, { point, side } });
      }
    };
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      offer(sides[i].from, static_cast<std::int32_t>(i), -1.0F);
      offer(sides[i].to, static_cast<std::int32_t>(i), -1.0F);
    }
    while (!front.empty())
    {
      const auto [away, from] = front.top();
      front.pop();
      const auto i = static_cast<std::size_t>(from.first);
      if (away > distances[i])
      {
        continue;
      }
      take(i, sides[static_cast<std::size_t>(from.second)], away);
      const auto around = this->Surface.links.around(from.first);
      for (const std::int32_t* t = around[0]; t != around[1]; ++t)
      {
        for (const std::int32_t corner : this->Surface.corners[static_cast<std::size_t>(*t)])
        {
          offer(corner, from.second, away);
        }
      }
    }
  }

private:
  const EdgeSurface& Surface;
};
} // namespace

EdgeDistance::EdgeDistance(const TriangleSpans& surface, double contactRadius, double reach)
  : EdgeDistance(EdgeSurface(surface), contactRadius, reach)
{
}

EdgeDistance::EdgeDistance(const EdgeSurface& surface, double contactRadius, double reach)
  : Found(surface.spans.pointCount)
{
  const SideSpread spread(surface);
  const std::vector<double> radii = cellRadii(surface, contactRadius, reach);
  std::vector<SurfaceEdges> found(radii.size());
  shareWork(radii.size(), [&](std::size_t i) { found[i] = findEdges(surface, radii[i]); });
  double inner = 0.0; // mm; edges at smaller distances were already searched with finer cells
  for (const SurfaceEdges& edges : found)
  {
    const bool isLast = &edges == &found.back();
    const double outer = isLast ? reach : LargestCellDistance * edges.cell;
    const auto takeStronger = [this, inner](std::size_t point, const SurfaceSide& side, float away)
    {
      NearEdge& nearest = this->Found[point];
      const double distance = std::max(static_cast<double>(away), inner);
      if (sharpnessOf(side.turn) * static_cast<double>(nearest.distance) >
        sharpnessOf(nearest.turn) * distance)
      {
        nearest.distance = static_cast<float>(distance);
        nearest.turn = side.turn;
        nearest.isSharp = side.isSharp;
      }
    };
    // Sharp and blunt edges are searched separately, so that a nearby blunt edge does not hide a
    // sharp one.
    std::vector<SurfaceSide> sharp;
    std::vector<SurfaceSide> blunt;
    for (const SurfaceSide& side : edges.sides)
    {
      (sharpnessOf(side.turn) > BluntSharpness ? sharp : blunt).push_back(side);
    }
    spread.from(sharp, outer, takeStronger);
    if (inner < BluntSharpness * reach)
    {
      spread.from(blunt, std::min(outer, BluntSharpness * reach), takeStronger);
    }
    this->EdgeCount = inner == 0.0 ? edges.sides.size() : this->EdgeCount;
    inner = outer;
  }
  spread.from(findBorder(surface, contactRadius), reach,
    [this](std::size_t point, const SurfaceSide&, float away)
    { this->Found[point].border = away; });
}

double edgeFactor(double poissonRatio, double distanceOverRadius, double sharpness)
{
  const double psi = pointLoadSoftness(poissonRatio);
  // Determines the fraction of the force that remains directly at the edge.
  constexpr double atEdge = 0.42;
  const double x = distanceOverRadius + atEdge * std::exp(-distanceOverRadius);
  return x / (x + sharpness * psi / Pi);
}
} // namespace palpate
