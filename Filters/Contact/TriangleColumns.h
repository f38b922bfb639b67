// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TriangleColumns_h
#define palpate_TriangleColumns_h

#include "Mechanics/PalpateExport.h"

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// Triangles sorted into columns along z, used to count the triangles above a point. If the
/// triangles of a surface have about the same size, a column contains only a few triangles. Slivers
/// that extend over many columns make the columns wider. There are at most Most entries per
/// triangle.
class PALPATE_EXPORT TriangleColumns
{
public:
  using Corners = std::array<Eigen::Vector3d, 3>;

  explicit TriangleColumns(std::vector<Corners> triangles);

  /// Returns the number of triangles that a ray upward from `place` crosses. The number is odd
  /// inside a closed surface.
  std::size_t crossingsAbove(const Eigen::Vector3d& place) const;

private:
  static constexpr std::size_t Most = 8;

  /// The columns below a triangle: the first and the last column along x and along y.
  struct Range
  {
    Eigen::Array2i low;
    Eigen::Array2i high;
  };
  Eigen::Array2i columnOf(const Eigen::Vector2d& place) const;
  Range below(const Corners& corners) const;
  std::size_t at(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(this->Side) +
      static_cast<std::size_t>(x);
  }

  std::vector<Corners> Triangles;
  Eigen::AlignedBox2d Box;
  int Side = 1;
  std::vector<std::vector<std::int32_t>> Columns;
};
} // namespace palpate

#endif
