// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PartOverlap_h
#define palpate_PartOverlap_h

#include "Contact/TriangleColumns.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <vector>

namespace palpate
{
/// Fractions of a surface that are inside a solid and on the surface of the solid, measured at
/// points spread over the surface. A point is on the solid's surface if only one of its two sides
/// is inside.
struct PartOverlap
{
  /// Number of points; at least half of this number is tested.
  static constexpr std::size_t Places = 4000;
  /// Smallest fraction at which parts count as overlapping or touching.
  static constexpr double Least = 0.002;

  /// `size` is the size of the surface, mm. The two sides of the surface are tested at a distance
  /// of 1e-5 times `size`.
  PartOverlap(const std::vector<TriangleColumns::Corners>& surface, double size,
    const TriangleColumns& solid, const Eigen::AlignedBox3d& box);

  bool isPresent() const { return this->inside > Least || this->touching > Least; }

  double inside = 0.0;
  double touching = 0.0;
};
} // namespace palpate

#endif
