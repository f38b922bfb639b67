// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SourceThinning_h
#define palpate_SourceThinning_h

#include "Solids/FiniteElements/BodySurface.h"

namespace palpate
{
/**
 * Returns a thinned set of the surface points `candidates`. The distance of two kept points on the
 * same side is at least the smaller of their spacings (mm; one spacing per candidate). A candidate
 * that would violate this is removed. Points on opposite sides of a thin part do not replace each
 * other. The candidates are visited in order; earlier ones have priority.
 */
std::vector<std::int32_t> thinnedSources(const BodySurface& surface,
  const std::vector<std::int32_t>& candidates, const std::vector<double>& spacings);
} // namespace palpate

#endif
