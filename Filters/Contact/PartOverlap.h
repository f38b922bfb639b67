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
/// two sides is inside). Both are fractions of places spread over the surface.
struct PartOverlap
{
  static constexpr std::size_t Places = 4000; ///< number of places tried; at least half of it
  static constexpr double Least = 0.002;      ///< fraction from which parts overlap or touch

  /// `size` of the surface, mm: the two sides are tested at 1e-5 of it from the surface.
  PartOverlap(const std::vector<TriangleColumns::Corners>& surface, double size,
    const TriangleColumns& solid, const Eigen::AlignedBox3d& box);

  bool isSome() const { return this->inside > Least || this->touching > Least; }

  double inside = 0.0;
  double touching = 0.0;
};
} // namespace palpate

#endif
