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
/// Triangles in columns along z, used to count the triangles above a place. If the triangles of a
/// surface have about one size, a column holds a few of them. Slivers across many columns make the
/// columns wider. At most Most entries per triangle.
class PALPATE_EXPORT TriangleColumns
{
public:
  using Corners = std::array<Eigen::Vector3d, 3>;

  explicit TriangleColumns(std::vector<Corners> triangles);

  /// How many triangles a ray upward from the place crosses: odd inside a closed surface.
  std::size_t crossingsAbove(const Eigen::Vector3d& place) const;

private:
  static constexpr std::size_t Most = 8;

  /// The columns below a triangle: first and last along x and y.
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
