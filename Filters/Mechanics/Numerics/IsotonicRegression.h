// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_IsotonicRegression_h
#define palpate_IsotonicRegression_h

#include "Mechanics/PalpateExport.h"

#include <vector>

namespace palpate
{
/// Returns the non-decreasing sequence closest to `values` in the least-squares sense, by pooling
/// adjacent violators (Ayer et al. 1955). `weights` > 0 are the weights of the squares; if empty,
/// all squares have equal weight. Cost: O(n).
PALPATE_EXPORT std::vector<double> isotonicRegression(
  const std::vector<double>& values, const std::vector<double>& weights = {});
} // namespace palpate

#endif
