// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SourceThinning_h
#define palpate_SourceThinning_h

#include "Solids/FiniteElements/BodySurface.h"

namespace palpate
{
/**
 * Thinned set of surface points. Two kept points on the same side are at least the smaller of their
 * two spacings apart (mm; one spacing per candidate), and each removed point has a kept point
 * nearer than that. Points on opposite sides of a thin part do not replace each other. The
 * candidates are visited in order; earlier ones have priority.
 */
std::vector<std::int32_t> thinnedSources(const BodySurface& surface,
  const std::vector<std::int32_t>& candidates, const std::vector<double>& spacings);
} // namespace palpate

#endif
