// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SourceThinning_h
#define palpate_SourceThinning_h

#include "Solids/FiniteElements/BodySurface.h"

namespace palpate
{
/**
 * Some of the surface points, so that those kept are no nearer to each other than the smaller of
 * their two spacings (mm; beside `candidates`), and every one left out has one kept as near. Points
 * on two sides of a thin part do not stand for each other. In the order of the candidates, first
 * come first kept.
 */
std::vector<std::int32_t> thinnedSources(const BodySurface& surface,
  const std::vector<std::int32_t>& candidates, const std::vector<double>& spacings);
} // namespace palpate

#endif
