// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_Agreement_h
#define palpate_testing_Agreement_h

#include <gtest/gtest.h>

#include <cmath>

namespace palpate::testing
{
/// True if |actual - expected| <= tolerance |expected|; never true for NaN.
inline ::testing::AssertionResult agrees(double actual, double expected, double tolerance)
{
  if (std::abs(actual - expected) <= tolerance * std::abs(expected))
  {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure()
    << ::testing::PrintToString(actual) << " instead of " << ::testing::PrintToString(expected)
    << ", relative error " << (actual - expected) / expected << " > " << tolerance;
}
} // namespace palpate::testing

#endif
