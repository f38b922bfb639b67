// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_Proportion_h
#define palpate_Proportion_h

#include "Mechanics/PalpateExport.h"

namespace palpate
{
/// A fraction of successes among independent trials, with its exact confidence interval.
struct Proportion
{
  int successes = 0;
  int trials = 0;
  double share = 0.5; ///< successes / trials; 0.5 if there are no trials
  double lower = 0.0;
  double upper = 1.0;
};

/**
 * Computes the confidence interval of Clopper and Pearson (1934). It consists of all probabilities
 * p for which the results "at least as many successes as observed" and "at most as many" both have
 * a probability of at least (1 - confidence) / 2. For any number of trials, the interval contains
 * the true probability with at least the given confidence.
 *
 * `successes` must be within 0 … trials and `confidence` within (0, 1); otherwise all results are
 * NaN. The results are accurate to 1e-12. The cost is about 10 µs per 100 trials.
 */
PALPATE_EXPORT Proportion proportionOf(int successes, int trials, double confidence = 0.95);

/// The quantile of the standard normal distribution. It is -inf for p = 0, +inf for p = 1 and NaN
/// for p outside [0, 1].
PALPATE_EXPORT double normalQuantile(double p);
} // namespace palpate

#endif
