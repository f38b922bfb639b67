// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/TriangleColumns.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
using Eigen::Vector3d;

/// Whether the upward ray from the place crosses the triangle; of an edge, one of its two
/// triangles.
bool isBelow(const Vector3d& place, const std::array<Vector3d, 3>& corners)
{
  bool isIn = false;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vector3d& a = corners[k];
    const Vector3d& b = corners[(k + 1) % 3];
    if ((a.y() > place.y()) != (b.y() > place.y()) &&
      place.x() < a.x() + (b.x() - a.x()) * ((place.y() - a.y()) / (b.y() - a.y())))
    {
      isIn = !isIn;
    }
  }
  if (!isIn)
  {
    return false;
  }
  const Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  return normal.dot(corners[0] - place) * normal.z() > 0.0;
}
} // namespace

TriangleColumns::TriangleColumns(const Eigen::AlignedBox3d& box, std::size_t count)
  : Low(box.min().head<2>())
  , Side(std::clamp(static_cast<int>(std::sqrt(0.25 * static_cast<double>(count))), 1, 1024))
  , Columns(static_cast<std::size_t>(Side) * static_cast<std::size_t>(Side))
{
  const Eigen::Array2d size = box.sizes().head<2>().array();
  this->PerMillimetre = (size > 0.0).select(static_cast<double>(this->Side) / size, 0.0);
}

Eigen::Array2i TriangleColumns::columnOf(const Vector3d& place) const
{
  const Eigen::Array2d at = (place.head<2>() - this->Low).array() * this->PerMillimetre;
  return at.floor().max(0.0).min(static_cast<double>(this->Side - 1)).cast<int>();
}

void TriangleColumns::add(const std::array<Vector3d, 3>& corners)
{
  Eigen::AlignedBox3d box;
  box.extend(corners[0]).extend(corners[1]).extend(corners[2]);
  const Eigen::Array2i low = this->columnOf(box.min());
  const Eigen::Array2i high = this->columnOf(box.max());
  for (int y = low.y(); y <= high.y(); ++y)
  {
    for (int x = low.x(); x <= high.x(); ++x)
    {
      this->at(x, y).push_back(corners);
    }
  }
}

std::size_t TriangleColumns::crossingsAbove(const Vector3d& place) const
{
  const Eigen::Array2i column = this->columnOf(place);
  const auto& triangles =
    this->Columns[static_cast<std::size_t>(column.y()) * static_cast<std::size_t>(this->Side) +
      static_cast<std::size_t>(column.x())];
  return static_cast<std::size_t>(std::count_if(triangles.begin(), triangles.end(),
    [&place](const std::array<Vector3d, 3>& corners) { return isBelow(place, corners); }));
}
} // namespace palpate
