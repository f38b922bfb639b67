// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/TriangleColumns.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
using Eigen::Vector3d;

/// Returns whether the upward ray from a point crosses the triangle. A ray through an edge crosses
/// exactly one of the two triangles of the edge.
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

TriangleColumns::TriangleColumns(std::vector<Corners> triangles)
  : Triangles(std::move(triangles))
{
  for (const Corners& corners : this->Triangles)
  {
    for (const Vector3d& corner : corners)
    {
      this->Box.extend(corner.head<2>().eval());
    }
  }
  const auto count = static_cast<double>(this->Triangles.size());
  this->Side = std::clamp(static_cast<int>(std::sqrt(0.25 * count)), 1, 1024);
  const auto entries = [this]()
  {
    std::size_t sum = 0;
    for (const Corners& corners : this->Triangles)
    {
      const Range range = this->below(corners);
      sum += static_cast<std::size_t>((range.high - range.low + 1).prod());
    }
    return sum;
  };
  while (this->Side > 1 && entries() > Most * this->Triangles.size())
  {
    this->Side /= 2;
  }
  this->Columns.resize(static_cast<std::size_t>(this->Side) * static_cast<std::size_t>(this->Side));
  for (std::size_t i = 0; i < this->Triangles.size(); ++i)
  {
    const Range range = this->below(this->Triangles[i]);
    for (int y = range.low.y(); y <= range.high.y(); ++y)
    {
      for (int x = range.low.x(); x <= range.high.x(); ++x)
      {
        this->Columns[this->at(x, y)].push_back(static_cast<std::int32_t>(i));
      }
    }
  }
}

Eigen::Array2i TriangleColumns::columnOf(const Eigen::Vector2d& place) const
{
  const Eigen::Array2d size = this->Box.sizes().array();
  const double side = this->Side;
  const Eigen::Array2d at =
    (size > 0.0).select(side * (place - this->Box.min()).array() / size, 0.0);
  return at.floor().max(0.0).min(side - 1.0).cast<int>();
}

TriangleColumns::Range TriangleColumns::below(const Corners& corners) const
{
  Eigen::AlignedBox2d box;
  for (const Vector3d& corner : corners)
  {
    box.extend(corner.head<2>().eval());
  }
  return { this->columnOf(box.min()), this->columnOf(box.max()) };
}

std::size_t TriangleColumns::crossingsAbove(const Vector3d& place) const
{
  const Eigen::Array2i column = this->columnOf(place.head<2>());
  const std::vector<std::int32_t>& near = this->Columns[this->at(column.x(), column.y())];
  return static_cast<std::size_t>(std::count_if(near.begin(), near.end(),
    [&](std::int32_t i) { return isBelow(place, this->Triangles[static_cast<std::size_t>(i)]); }));
}
} // namespace palpate
