// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TrialPlan_h
#define palpate_TrialPlan_h

#include "Mechanics/PalpateExport.h"

#include <cstdint>
#include <vector>

namespace palpate
{
/// One question, with two alternatives. `x` and `y` are the indices of the alternatives that are
/// presented as X and as Y.
struct Trial
{
  int x = 0;
  int y = 0;
};

/**
 * The order of a blind comparison. In each round every pair of the alternatives occurs once as (X,
 * Y) and once as (Y, X), in random order. Therefore after each round all pairs have been asked
 * equally often, and each alternative has been X as often as Y. Therefore neither learning nor a
 * bias towards X favours an alternative.
 *
 * The result has rounds · alternatives · (alternatives - 1) trials. It is empty if there are fewer
 * than two alternatives. The same seed results in the same order on every machine (Mersenne
 * Twister, Fisher–Yates).
 */
PALPATE_EXPORT std::vector<Trial> planTrials(int alternatives, int rounds, std::uint64_t seed);
} // namespace palpate

#endif
