// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PartOverlap_h
#define palpate_PartOverlap_h

#include "Contact/TriangleColumns.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <vector>

namespace palpate
{
/// Fractions of a surface that are inside a solid and on the solid's surface (where only one of the
/// two sides is inside), measured at points spread over the surface.
struct PartOverlap
{
  static constexpr std::size_t Places = 4000; ///< number of points; at least half of it is tested
  static constexpr double Least = 0.002;      ///< least fraction at which parts overlap or touch

  /// `size` is that of the surface, mm: its two sides are tested at a distance of 1e-5 of `size`.
  PartOverlap(const std::vector<TriangleColumns::Corners>& surface, double size,
    const TriangleColumns& solid, const Eigen::AlignedBox3d& box);

  bool isPresent() const { return this->inside > Least || this->touching > Least; }

  double inside = 0.0;
  double touching = 0.0;
};
} // namespace palpate

#endif
