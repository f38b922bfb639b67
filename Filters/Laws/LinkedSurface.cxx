// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/LinkedSurface.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace palpate
{
using Eigen::Vector3d;

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
