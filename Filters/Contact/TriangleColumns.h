// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TriangleColumns_h
#define palpate_TriangleColumns_h

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <vector>

namespace palpate
{
/// Triangles in columns along z, for counting those above a place. A column holds a few triangles
/// of a surface whose triangles have about one size.
class TriangleColumns
{
public:
  /// `box` of all triangles, and about how many there are.
  TriangleColumns(const Eigen::AlignedBox3d& box, std::size_t count);

  void add(const std::array<Eigen::Vector3d, 3>& corners);

  /// How many triangles a ray upward from the place crosses: odd inside a closed surface.
  std::size_t crossingsAbove(const Eigen::Vector3d& place) const;

private:
  Eigen::Array2i columnOf(const Eigen::Vector3d& place) const;
  std::vector<std::array<Eigen::Vector3d, 3>>& at(int x, int y)
  {
    return this->Columns[static_cast<std::size_t>(y) * static_cast<std::size_t>(this->Side) +
      static_cast<std::size_t>(x)];
  }

  Eigen::Vector2d Low;
  Eigen::Array2d PerMillimetre;
  int Side;
  std::vector<std::vector<std::array<Eigen::Vector3d, 3>>> Columns;
};
} // namespace palpate

#endif
