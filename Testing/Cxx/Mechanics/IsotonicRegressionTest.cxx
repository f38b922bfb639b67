// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Numerics/IsotonicRegression.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

using palpate::isotonicRegression;

namespace
{
/// The min-max formula (Robertson, Wright and Dykstra 1988, theorem 1.4.4): the value at i is the
/// maximum over a <= i of the minimum over b >= i of the mean of a..b.
std::vector<double> bruteForce(const std::vector<double>& values)
{
  std::vector<double> fitted;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    double largest = -std::numeric_limits<double>::infinity();
    for (std::size_t a = 0; a <= i; ++a)
    {
      double smallest = std::numeric_limits<double>::infinity();
      double sum = 0.0;
      for (std::size_t b = a; b < values.size(); ++b)
      {
        sum += values[b];
        if (b >= i)
        {
          smallest = std::min(smallest, sum / static_cast<double>(b - a + 1));
        }
      }
      largest = std::max(largest, smallest);
    }
    fitted.push_back(largest);
  }
  return fitted;
}
} // namespace

TEST(IsotonicRegression, AgreesWithTheMinMaxFormula)
{
  std::mt19937 random(7);
  std::normal_distribution<double> noise;
  for (const std::size_t count : { 1U, 2U, 3U, 10U, 60U })
  {
    for (const double trend : { -0.3, 0.0, 0.1, 1.0 })
    {
      std::vector<double> values(count);
      for (std::size_t i = 0; i < count; ++i)
      {
        values[i] = trend * static_cast<double>(i) + noise(random);
      }
      const std::vector<double> fitted = isotonicRegression(values);
      const std::vector<double> expected = bruteForce(values);
      ASSERT_EQ(fitted.size(), count);
      EXPECT_TRUE(std::is_sorted(fitted.begin(), fitted.end()));
      for (std::size_t i = 0; i < count; ++i)
      {
        // sums of 60 numbers of order 10, added in another order
        EXPECT_NEAR(fitted[i], expected[i], 1e-13);
      }
    }
  }
}

TEST(IsotonicRegression, LeavesWhatIsMonotone)
{
  const std::vector<double> rising = { -1.0, 0.0, 0.0, 2.5, 7.0 };
  EXPECT_EQ(isotonicRegression(rising), rising);
  EXPECT_TRUE(isotonicRegression({}).empty());
}
