// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/ReducedModulus.h"

#include "Agreement.h"
#include "Mechanics/Numerics/Constants.h"

#include <limits>

using palpate::Infinity;
using palpate::NotANumber;
using palpate::reducedModulus;
using palpate::testing::agrees;

TEST(ReducedModulus, Values)
{
  EXPECT_EQ(reducedModulus(2.0, 0.0), 2.0);
  EXPECT_EQ(reducedModulus(3.0, 0.5), 4.0); // 3/(1 - 1/4)
  // 0.91/(1 - 0.09) = 1, to a few roundings.
  EXPECT_TRUE(agrees(reducedModulus(0.91, 0.3), 1.0, 4e-16));
}

TEST(ReducedModulus, InvalidIsNaN)
{
  for (const double modulus : { 0.0, -1.0, Infinity, NotANumber })
  {
    EXPECT_FALSE(palpate::isYoungsModulus(modulus)) << modulus;
    EXPECT_TRUE(std::isnan(reducedModulus(modulus, 0.3))) << modulus;
  }
  for (const double ratio : { -1e-9, std::nextafter(0.5, 1.0), 1.0, -1.0, Infinity, NotANumber })
  {
    EXPECT_FALSE(palpate::isPoissonsRatio(ratio)) << ratio;
    EXPECT_TRUE(std::isnan(reducedModulus(1.0, ratio))) << ratio;
  }
}

TEST(ReducedModulus, BothEndsOfTheRangeAreLegal)
{
  EXPECT_TRUE(palpate::isPoissonsRatio(0.0));
  EXPECT_TRUE(palpate::isPoissonsRatio(0.5));
  EXPECT_TRUE(palpate::isYoungsModulus(std::numeric_limits<double>::min()));
}
