// SPDX-License-Identifier: BSD-3-Clause
#include "Trials/Proportion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using palpate::normalQuantile;
using palpate::proportionOf;

TEST(Proportion, IntervalOfNoneAndOfAllInClosedForm)
{
  // For no success in n: p with (1-p)^n = 0.025. For n successes in n: p^n = 0.025.
  for (const int n : { 1, 10, 37, 1000 })
  {
    const double root = std::pow(0.025, 1.0 / n);
    EXPECT_EQ(proportionOf(0, n).lower, 0.0);
    EXPECT_NEAR(proportionOf(0, n).upper, 1.0 - root, 1e-12);
    EXPECT_NEAR(proportionOf(n, n).lower, root, 1e-12);
    EXPECT_EQ(proportionOf(n, n).upper, 1.0);
  }
}

TEST(Proportion, PublishedIntervals)
{
  // Mendel's peas (Conover 1971), the example of R's binom.test, with seven digits.
  const auto peas = proportionOf(682, 925);
  EXPECT_NEAR(peas.share, 0.7372973, 5e-8);
  EXPECT_NEAR(peas.lower, 0.7076683, 5e-8);
  EXPECT_NEAR(peas.upper, 0.7654066, 5e-8);
  // 5 of 10, to four digits, from published tables of this interval.
  EXPECT_NEAR(proportionOf(5, 10).lower, 0.1871, 5e-5);
  EXPECT_NEAR(proportionOf(5, 10).upper, 0.8129, 5e-5);
}

TEST(Proportion, TailsAreThoseOfTheBinomialDistribution)
{
  // n is small enough for a sum with exact coefficients.
  const double coefficients[] = { 1, 7, 21, 35, 35, 21, 7, 1 };
  for (int k = 1; k < 7; ++k)
  {
    const auto interval = proportionOf(k, 7, 0.9);
    double atLeast = 0.0;
    double atMost = 0.0;
    for (int i = 0; i <= 7; ++i)
    {
      const auto weight = [&](double p)
      { return coefficients[i] * std::pow(p, i) * std::pow(1 - p, 7 - i); };
      atLeast += i >= k ? weight(interval.lower) : 0.0;
      atMost += i <= k ? weight(interval.upper) : 0.0;
    }
    EXPECT_NEAR(atLeast, 0.05, 1e-12); // rounding of the interval, times a slope of a few
    EXPECT_NEAR(atMost, 0.05, 1e-12);
  }
}

TEST(Proportion, SeenFromTheOtherSide)
{
  for (int k = 0; k <= 30; ++k)
  {
    EXPECT_NEAR(proportionOf(k, 30).lower, 1.0 - proportionOf(30 - k, 30).upper, 1e-13);
  }
}

TEST(Proportion, OfNoTrialsNothingIsKnown)
{
  const auto nothing = proportionOf(0, 0);
  EXPECT_EQ(nothing.lower, 0.0);
  EXPECT_EQ(nothing.upper, 1.0);
  for (const auto& wrong : { proportionOf(-1, 5), proportionOf(6, 5), proportionOf(1, 5, 1.0) })
  {
    EXPECT_TRUE(std::isnan(wrong.share) && std::isnan(wrong.lower) && std::isnan(wrong.upper));
  }
}

TEST(Proportion, NormalQuantile)
{
  // Abramowitz and Stegun, Handbook of Mathematical Functions, table 26.5; and the symmetry of the
  // function.
  EXPECT_NEAR(normalQuantile(0.75), 0.674489750196082, 1e-13);
  EXPECT_NEAR(normalQuantile(0.975), 1.959963984540054, 1e-13);
  EXPECT_NEAR(normalQuantile(0.001), -3.090232306167814, 1e-13);
  EXPECT_NEAR(normalQuantile(0.5), 0.0, 1e-13);
  EXPECT_EQ(normalQuantile(1.0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(normalQuantile(0.0), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(normalQuantile(-0.1)) && std::isnan(normalQuantile(std::nan(""))));
}
