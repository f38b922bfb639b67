// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SourceThinning_h
#define palpate_SourceThinning_h

#include "Solids/FiniteElements/BodySurface.h"

namespace palpate
{
/**
 * Returns a thinned set of the surface points `candidates`. The distance of two kept points on the
 * same side of the body is at least the smaller of their spacings. `spacings` has one spacing per
 * candidate, mm. A candidate that would violate this condition is removed. Points on opposite sides
 * of a thin part do not replace each other. The candidates are visited in order, so that earlier
 * candidates have priority.
 */
std::vector<std::int32_t> thinnedSources(const BodySurface& surface,
  const std::vector<std::int32_t>& candidates, const std::vector<double>& spacings);
} // namespace palpate

#endif
