// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_NearestAlong_h
#define palpate_NearestAlong_h

#include "Solids/FiniteElements/BodySurface.h"
#include "Mechanics/PalpateExport.h"

#include <functional>

namespace palpate
{
/// A point of a surface and its distance along the edges, mm.
struct AlongSurface
{
  std::int32_t point;
  double distance;
};

/// Returns the `count` points nearest to `point` along the edges of the surface, the nearest first.
/// Only points for which `isWanted` returns true are found. Paths do not pass through another
/// wanted point. Returns fewer points if the connected part of the surface has fewer.
PALPATE_EXPORT std::vector<AlongSurface> nearestAlong(const BodySurface& surface,
  std::int32_t point, std::size_t count, const std::function<bool(std::int32_t)>& isWanted);

/// Returns weights proportional to 1/distance², with sum 1, in the order of `found`.
PALPATE_EXPORT std::vector<double> weightsAlong(const std::vector<AlongSurface>& found);
} // namespace palpate

#endif
