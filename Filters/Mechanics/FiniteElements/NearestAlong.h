// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_NearestAlong_h
#define palpate_NearestAlong_h

#include "Mechanics/FiniteElements/BodySurface.h"
#include "Mechanics/PalpateExport.h"

#include <functional>

namespace palpate
{
/// A point of a surface and how far it is along the edges, mm.
struct AlongSurface
{
  std::int32_t point;
  double distance;
};

/// The nearest points from `point` along the edges of the surface that are wanted, up to `count` of
/// them, none behind another; nearest first. Fewer where that part of the surface has no more.
PALPATE_EXPORT std::vector<AlongSurface> nearestAlong(const BodySurface& surface,
  std::int32_t point, std::size_t count, const std::function<bool(std::int32_t)>& isWanted);

/// By 1/distance², in sum 1; beside `found`.
PALPATE_EXPORT std::vector<double> weightsAlong(const std::vector<AlongSurface>& found);
} // namespace palpate

#endif
