// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/LinkedSurface.h"

#include "Mechanics/Numerics/Constants.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace palpate
{
namespace
{
using Eigen::Vector3d;

constexpr double SmallestBorder = 4.0; // radius of the largest hole, in contact radii

/// Removes loops shorter than `least` (mm), which are holes in a scan.
void dropHoles(const LinkedSurface& surface, double least, std::vector<SurfaceSide>& border)
{
  std::map<std::int32_t, std::int32_t> above;
  const auto rootOf = [&above](std::int32_t i)
  {
    above.emplace(i, i);
    while (above[i] != i)
    {
      i = above[i] = above[above[i]];
    }
    return i;
  };
  for (const SurfaceSide& side : border)
  {
    above[rootOf(side.from)] = rootOf(side.to);
  }
  std::map<std::int32_t, double> lengths;
  for (const SurfaceSide& side : border)
  {
    lengths[rootOf(side.from)] += (surface.place(side.to) - surface.place(side.from)).norm();
  }
  border.erase(std::remove_if(border.begin(), border.end(),
                 [&](const SurfaceSide& side) { return lengths[rootOf(side.from)] < least; }),
    border.end());
}
} // namespace

LinkedSurface::LinkedSurface(const TriangleSpans& surface)
  : spans(surface)
  , corners(surface.triangleCount)
  , areas(surface.triangleCount, Vector3d::Zero())
  , links(this->findCorners(), surface.pointCount)
{
}

const std::vector<TriangleCorners>& LinkedSurface::findCorners()
{
  for (std::size_t t = 0; t < this->corners.size(); ++t)
  {
    TriangleCorners& c = this->corners[t];
    std::copy_n(this->spans.triangles + 3 * t, 3, c.begin());
    const Vector3d first = this->place(c[0]);
    const Vector3d twice = (this->place(c[1]) - first).cross(this->place(c[2]) - first);
    if (twice.squaredNorm() > 0.0 && std::isfinite(twice.squaredNorm()))
    {
      this->areas[t] = 0.5 * twice;
    }
    else
    {
      c.fill(-1);
    }
  }
  return this->corners;
}

std::size_t LinkedSurface::usedPoints() const
{
  std::size_t count = 0;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(this->spans.pointCount); ++i)
  {
    const auto around = this->links.around(i);
    count += around[0] != around[1];
  }
  return count;
}

std::vector<SurfaceSide> findBorder(const LinkedSurface& surface, double contactRadius)
{
  // Counts the sides of a single facet by position. Sides of duplicate points occur twice.
  using Place = std::array<double, 3>;
  std::map<std::pair<Place, Place>, int> at;
  std::vector<SurfaceSide> border;
  const auto keyOf = [&surface](const SurfaceSide& side)
  {
    Place one;
    Place other;
    std::copy_n(surface.place(side.from).data(), 3, one.begin());
    std::copy_n(surface.place(side.to).data(), 3, other.begin());
    return one < other ? std::make_pair(one, other) : std::make_pair(other, one);
  };
  for (std::size_t t = 0; t < surface.corners.size(); ++t)
  {
    const TriangleCorners& c = surface.corners[t];
    for (std::size_t i = 0; c[0] >= 0 && i < 3; ++i)
    {
      const SurfaceSide side{ c[i], c[(i + 1) % 3], 0.0F };
      if (surface.links.neighbours(t)[i] == TriangleLinks::Border)
      {
        border.push_back(side);
        ++at[keyOf(side)];
      }
    }
  }
  border.erase(std::remove_if(border.begin(), border.end(),
                 [&](const SurfaceSide& side) { return at[keyOf(side)] > 1; }),
    border.end());
  dropHoles(surface, Pi * SmallestBorder * contactRadius, border);
  return border;
}
double pointSpacing(const TriangleSpans& surface)
{
  const auto place = [&](std::int32_t point) {
    return Eigen::Map<const Eigen::Vector3d>(surface.points + 3 * static_cast<std::size_t>(point));
  };
  double twice = 0.0;
  std::vector<bool> isUsed(surface.pointCount, false);
  for (std::size_t t = 0; t < surface.triangleCount; ++t)
  {
    const std::int32_t* corner = surface.triangles + 3 * t;
    const double area =
      (place(corner[1]) - place(corner[0])).cross(place(corner[2]) - place(corner[0])).norm();
    twice += std::isfinite(area) ? area : 0.0;
    for (int k = 0; k < 3; ++k)
    {
      isUsed[static_cast<std::size_t>(corner[k])] = true;
    }
  }
  return std::sqrt(
    0.5 * twice / static_cast<double>(std::count(isUsed.begin(), isUsed.end(), true)));
}

} // namespace palpate
