// SPDX-License-Identifier: BSD-3-Clause
// Curves whose stiffness is reported to rise over the whole range: closed forms, and random curves
// against a dense scan.
#include "Contact/RisingStiffness.h"

#include "Contact/ResponseSampling.h"
#include "SampleResponses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>

using namespace palpate::testing;
using palpate::FloatCurve;
using palpate::ResponseField;
using palpate::ResponseSampling;
using palpate::RisingStiffness;

namespace
{
constexpr int SampleCount = 8;
constexpr double RisingRange = 1.7;

struct Stored
{
  std::array<float, SampleCount> forces;
  std::array<float, SampleCount> stiffnesses;
  FloatCurve curve() const { return { this->forces.data(), this->stiffnesses.data() }; }
};

Stored powerLaw(double scale, double power)
{
  const ResponseSampling sampling(SampleCount, 1.5);
  Stored stored;
  for (int i = 0; i < SampleCount; ++i)
  {
    const double depth = sampling.depth(i, RisingRange);
    const auto at = static_cast<std::size_t>(i);
    stored.forces[at] = static_cast<float>(scale * std::pow(depth, power));
    stored.stiffnesses[at] = static_cast<float>(scale * power * std::pow(depth, power - 1.0));
  }
  return stored;
}

/// Largest drop of the stiffness below an earlier value, relative to the largest stiffness.
double largestFall(const ResponseSampling& sampling, const FloatCurve& curve)
{
  double largest = 0.0;
  double fall = 0.0;
  for (int i = 1; i <= 4000; ++i)
  {
    const double root = 1.1 * i / 4000.0;
    const double stiffness =
      sampling.evaluate(curve, RisingRange, RisingRange * root * root).stiffness;
    fall = std::max(fall, largest - stiffness);
    largest = std::max(largest, stiffness);
  }
  return fall / largest;
}
} // namespace

TEST(RisingStiffness, PowerLawsInTheirOwnExponent)
{
  for (const double power : { 1.0, 1.25, 1.5, 2.0, 3.0 })
  {
    const ResponseSampling sampling(SampleCount, power);
    const RisingStiffness rising(sampling);
    for (const double scale : { 1e-5, 0.37, 13.0, 1e6 })
    {
      EXPECT_TRUE(rising.isOf(powerLaw(scale, power).curve(), RisingRange))
        << power << ' ' << scale;
    }
  }
  const RisingStiffness rising(ResponseSampling(SampleCount, 0.9));
  EXPECT_FALSE(rising.isOf(powerLaw(2.0, 0.9).curve(), RisingRange));
}

TEST(RisingStiffness, OneSampleOfManyThatIsLessStiff)
{
  const RisingStiffness rising(ResponseSampling(SampleCount, 1.5));
  for (std::size_t i = 0; i < SampleCount; ++i)
  {
    Stored stored = powerLaw(10.0, 1.5);
    stored.stiffnesses[i] *= 0.5F;
    EXPECT_FALSE(rising.isOf(stored.curve(), RisingRange)) << i;
    stored.stiffnesses[i] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(rising.isOf(stored.curve(), RisingRange)) << i;
  }
  Stored pulling = powerLaw(10.0, 1.5);
  pulling.forces[0] *= -1.0F;
  EXPECT_FALSE(rising.isOf(pulling.curve(), RisingRange));
  const Stored nothing = powerLaw(0.0, 1.5);
  EXPECT_TRUE(rising.isOf(nothing.curve(), RisingRange));
}

// Sums of power laws with increasing disturbance. No curve with a falling stiffness is reported as
// rising. Curves with hardly any disturbance are reported as rising.
TEST(RisingStiffness, RandomCurvesAgainstADenseWalk)
{
  const ResponseSampling sampling(SampleCount, 1.5);
  const RisingStiffness rising(sampling);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  int told = 0;
  int fell = 0;
  for (int trial = 0; trial < 2000; ++trial)
  {
    const double disturbed = std::pow(share(random), 3.0);
    const Stored sphere = powerLaw(10.0 * share(random), 1.5);
    const Stored cone = powerLaw(10.0 * share(random), 2.0);
    Stored stored;
    for (std::size_t i = 0; i < SampleCount; ++i)
    {
      const double more = 1.0 + disturbed * (share(random) - 0.5);
      stored.forces[i] = static_cast<float>(sphere.forces[i] + cone.forces[i]);
      stored.stiffnesses[i] =
        static_cast<float>(more * static_cast<double>(sphere.stiffnesses[i] + cone.stiffnesses[i]));
    }
    const double fall = largestFall(sampling, stored.curve());
    const bool isTold = rising.isOf(stored.curve(), RisingRange);
    // Rounding of floats over 8 cells.
    EXPECT_TRUE(!isTold || fall < 1e-6) << trial << ' ' << fall;
    told += isTold;
    fell += fall > 1e-6;
  }
  EXPECT_GT(told, 400);
  EXPECT_GT(fell, 400);
}

TEST(RisingStiffness, OfAFieldAllPointsCount)
{
  ResponseStore store(5); // F = 10 δ^1.5
  EXPECT_TRUE(ResponseField(store.arrays()).hasRisingStiffness());
  store.stiffness[8 * 3 + 5] *= 0.5F;
  EXPECT_FALSE(ResponseField(store.arrays()).hasRisingStiffness());
  store.range[3] = 0.0F; // a point without a response
  EXPECT_TRUE(ResponseField(store.arrays()).hasRisingStiffness());
}
