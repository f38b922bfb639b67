// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/HeldRim.h"

#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Numerics/SegmentDistance.h"
#include "Solids/TrueShape/SurfaceDisc.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace palpate
{
HeldRim::HeldRim(const ElasticBody& body)
{
  const BodySurface& surface = body.surface();
  const auto isHeld = [&](std::int32_t point) { return body.isHeld(surface.node(point)); };
  struct Sides
  {
    bool isHeld = false;
    Eigen::Vector3d free = Eigen::Vector3d::Zero(); ///< normal of a free triangle
  };
  std::map<std::pair<std::int32_t, std::int32_t>, Sides> edges;
  for (std::int32_t t = 0; t < surface.triangleTotal(); ++t)
  {
    const std::array<std::int32_t, 3>& corners = surface.triangle(t);
    const bool isAllHeld = std::all_of(corners.begin(), corners.end(), isHeld);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::pair<std::int32_t, std::int32_t> ends =
        std::minmax(corners[k], corners[(k + 1) % 3]);
      if (!isHeld(ends.first) || !isHeld(ends.second))
      {
        continue;
      }
      Sides& sides = edges[ends];
      sides.isHeld = sides.isHeld || isAllHeld;
      sides.free = isAllHeld ? sides.free : surface.triangleNormal(t);
    }
  }
  for (const auto& [ends, sides] : edges)
  {
    if (sides.isHeld && !sides.free.isZero())
    {
      this->Edges.push_back(
        { surface.position(ends.first), surface.position(ends.second), sides.free });
    }
  }
}

double HeldRim::distance(const Eigen::Vector3d& place, const Eigen::Vector3d& normal) const
{
  double square = Infinity;
  for (const Edge& edge : this->Edges)
  {
    if (edge.normal.dot(normal) >= ContactTurn)
    {
      const Eigen::Vector3d from = edge.from - place;
      const Eigen::Vector3d to = edge.to - place;
      square = std::min(square, squareToSegment(from, to));
    }
  }
  return std::sqrt(square);
}
} // namespace palpate
