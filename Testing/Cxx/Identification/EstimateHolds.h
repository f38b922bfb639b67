// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_EstimateHolds_h
#define palpate_testing_EstimateHolds_h

#include "Identification/Estimate.h"

namespace palpate::testing
{
/// True if the interval contains the true value.
inline bool holds(const Estimate& estimate, double truth)
{
  return estimate.lower <= truth && truth <= estimate.upper;
}
} // namespace palpate::testing

#endif
