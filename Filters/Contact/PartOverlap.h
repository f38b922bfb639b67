// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PartOverlap_h
#define palpate_PartOverlap_h

#include "Contact/TriangleColumns.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <vector>

namespace palpate
{
/// How much of a surface is inside a solid, and how much of it lies on the solid's surface: there
/// one of its two sides is inside. Both are shares of places that are spread over the surface.
struct PartOverlap
{
  static constexpr std::size_t Places = 4000; ///< that are tried, at least half as many
  static constexpr double Least = 0.002;      ///< share from which parts overlap, or touch

  /// `size` of the surface, mm: its two sides are looked at a hundred-thousandth of it away.
  PartOverlap(const std::vector<TriangleColumns::Corners>& surface, double size,
    const TriangleColumns& solid, const Eigen::AlignedBox3d& box);

  bool isSome() const { return this->inside > Least || this->touching > Least; }

  double inside = 0.0;
  double touching = 0.0;
};
} // namespace palpate

#endif
