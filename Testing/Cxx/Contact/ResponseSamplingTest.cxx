// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/ResponseSampling.h"

#include "Agreement.h"
#include "ContractCurve.h"
#include "Mechanics/Numerics/Constants.h"

#include <cstddef>
#include <random>

using palpate::Infinity;
using palpate::NotANumber;
using palpate::ResponseSampling;
using palpate::ResponseValue;
using palpate::testing::agrees;
using palpate::testing::ContractCurve;
using palpate::testing::ContractValue;

namespace
{
struct ManySamples
{
  std::vector<double> forces;
  std::vector<double> stiffnesses;
  double force(int i) const { return this->forces[static_cast<std::size_t>(i)]; }
  double stiffness(int i) const { return this->stiffnesses[static_cast<std::size_t>(i)]; }
};

ManySamples powerLaw(const ResponseSampling& sampling, double range, double exponent)
{
  ManySamples samples;
  for (int i = 0; i < sampling.samples(); ++i)
  {
    const double depth = sampling.depth(i, range);
    samples.forces.push_back(2.5 * std::pow(depth, exponent));
    samples.stiffnesses.push_back(2.5 * exponent * std::pow(depth, exponent - 1.0));
  }
  return samples;
}

/// Random increasing forces with random stiffness.
ManySamples monotone(std::mt19937& random, int n, double range)
{
  std::uniform_real_distribution<double> share(0.0, 1.0);
  ManySamples samples;
  double force = 0.0;
  for (int i = 0; i < n; ++i)
  {
    force += share(random);
    samples.forces.push_back(force);
    samples.stiffnesses.push_back(3.0 * n * share(random) / range);
  }
  return samples;
}

} // namespace

TEST(ResponseSampling, DepthsOfTheSamples)
{
  const ResponseSampling sampling(8, 1.5);
  for (int i = 1; i <= 8; ++i)
  {
    EXPECT_EQ(sampling.depth(i - 1, 2.0), 2.0 * i * i / 64.0); // exact in binary
  }
}

TEST(ResponseSampling, ExactForItsOwnPower)
{
  for (const double exponent : { 1.0, 1.5, 2.0 })
  {
    const ResponseSampling sampling(8, exponent);
    const double range = 1.7;
    const ManySamples samples = powerLaw(sampling, range, exponent);
    for (int i = 1; i <= 1000; ++i)
    {
      const double depth = 1e-3 * i * range;
      const ResponseValue value = sampling.evaluate(samples, range, depth);
      // Tolerance: rounding of pow and of the interpolation.
      EXPECT_TRUE(agrees(value.force, 2.5 * std::pow(depth, exponent), 2e-15));
      EXPECT_TRUE(agrees(value.stiffness, 2.5 * exponent * std::pow(depth, exponent - 1.0), 2e-14));
      EXPECT_FALSE(value.beyondRange);
    }
  }
}

TEST(ResponseSampling, PassesThroughItsSamplesWithTheirSlopes)
{
  std::mt19937 random(8);
  for (int trial = 0; trial < 200; ++trial)
  {
    const int n = 2 + trial % 9;
    const ResponseSampling sampling(n, trial % 2 == 0 ? 1.0 : 1.5);
    const double range = 0.5 + 0.01 * trial;
    const ManySamples samples = monotone(random, n, range);
    for (int i = 0; i < n; ++i)
    {
      const double knot = sampling.depth(i, range);
      const double scale = samples.forces.back() / range;
      const bool steep = i == 0 && samples.stiffness(0) * knot > 20.0 * samples.force(0);
      for (const double side : { 1.0 - 1e-12, 1.0, 1.0 + 1e-12 })
      {
        const ResponseValue value = sampling.evaluate(samples, range, side * knot);
        // The depth has an error of 1e-12. This changes F by K δ 1e-12, and K by F'' δ 1e-12 with
        // F'' <= 50 n F/δ² here.
        EXPECT_NEAR(value.force, samples.force(i), 1e-10 * samples.forces.back());
        EXPECT_NEAR(value.stiffness, samples.stiffness(i), (steep ? 1e-6 : 1e-8) * n * n * scale);
      }
    }
  }
}

TEST(ResponseSampling, PowerStart)
{
  const ResponseSampling sampling(4, 1.0);
  const double range = 1.6; // the first sample is at 0.1 mm
  ManySamples samples{ { 0.3, 1.0, 2.0, 4.0 }, { 6.0, 5.0, 5.0, 6.0 } };
  // q = 6·0.1/0.3 = 2, thus F = 30 δ².
  for (const double depth : { 1e-9, 1e-3, 0.05, 0.0999 })
  {
    const ResponseValue value = sampling.evaluate(samples, range, depth);
    EXPECT_TRUE(agrees(value.force, 30.0 * depth * depth, 1e-14)); // q is rounded: 1e-16 ln(1e8)
    EXPECT_TRUE(agrees(value.stiffness, 60.0 * depth, 1e-14));
  }
  samples.forces[0] = 0.0; // a curve without force at the first sample
  EXPECT_EQ(sampling.evaluate(samples, range, 0.05).force, 0.0);
  EXPECT_EQ(sampling.evaluate(samples, range, 0.05).stiffness, 0.0);
}

TEST(ResponseSampling, BeyondTheRangeTheLastTangent)
{
  const ResponseSampling sampling(8, 1.5);
  const ManySamples samples = powerLaw(sampling, 2.0, 1.5);
  const ResponseValue at = sampling.evaluate(samples, 2.0, 2.0);
  EXPECT_EQ(at.force, samples.force(7));
  EXPECT_EQ(at.stiffness, samples.stiffness(7));
  EXPECT_FALSE(at.beyondRange);
  EXPECT_FALSE(sampling.evaluate(samples, 2.0, std::nextafter(2.0, 0.0)).beyondRange);
  EXPECT_TRUE(sampling.evaluate(samples, 2.0, std::nextafter(2.0, 3.0)).beyondRange);
  for (const double depth : { 2.5, 100.0 })
  {
    const ResponseValue value = sampling.evaluate(samples, 2.0, depth);
    EXPECT_TRUE(value.beyondRange);
    EXPECT_TRUE(
      agrees(value.force, samples.force(7) + samples.stiffness(7) * (depth - 2.0), 1e-15));
    EXPECT_EQ(value.stiffness, samples.stiffness(7));
  }
}

TEST(ResponseSampling, NoContactAndNaN)
{
  const ResponseSampling sampling(8, 1.5);
  const ManySamples samples = powerLaw(sampling, 2.0, 1.5);
  for (const double depth : { 0.0, -0.0, -1e-300, -5.0, -Infinity })
  {
    const ResponseValue value = sampling.evaluate(samples, 2.0, depth);
    EXPECT_EQ(value.force, 0.0);
    EXPECT_EQ(value.stiffness, 0.0);
    EXPECT_FALSE(value.beyondRange);
  }
  EXPECT_TRUE(std::isnan(sampling.evaluate(samples, 2.0, NotANumber).force));
  EXPECT_TRUE(std::isnan(sampling.evaluate(samples, 2.0, NotANumber).stiffness));
  EXPECT_FALSE(sampling.evaluate(samples, 2.0, NotANumber).beyondRange);
}

TEST(ResponseSampling, TheContractWrittenOutAgain)
{
  std::mt19937 random(9);
  std::uniform_real_distribution<double> share(0.0, 1.2);
  for (int trial = 0; trial < 300; ++trial)
  {
    const int n = 2 + trial % 12;
    const double exponent = trial % 3 == 0 ? 1.0 : trial % 3 == 1 ? 1.5 : 0.7 + share(random);
    const double range = 0.1 + 3.0 * share(random);
    const ResponseSampling sampling(n, exponent);
    const ManySamples samples = monotone(random, n, range);
    const ContractCurve contract{ exponent, range, samples.forces, samples.stiffnesses };
    for (int i = 0; i < 100; ++i)
    {
      const double depth = share(random) * range;
      const ResponseValue value = sampling.evaluate(samples, range, depth);
      const ContractValue expected = contract.evaluate(depth);
      // Interpolants oscillate between a few times the largest force (stiffness: times n²/δ_max).
      // The rounding is 1e-12 of this.
      const double force = samples.forces.back();
      EXPECT_NEAR(value.force, expected.force, 1e-12 * force);
      EXPECT_NEAR(value.stiffness, expected.stiffness,
        1e-12 * (std::abs(expected.stiffness) + force * n * n / range));
      EXPECT_EQ(value.beyondRange, expected.beyondRange);
    }
  }
}

TEST(ResponseSampling, StiffnessIsTheSlopeOfTheForce)
{
  std::mt19937 random(10);
  for (int trial = 0; trial < 50; ++trial)
  {
    const int n = 8;
    const double range = 2.0;
    const ResponseSampling sampling(n, trial % 2 == 0 ? 1.0 : 1.5);
    const ManySamples samples = monotone(random, n, range);
    for (int k = 0; k < 3 * n; ++k)
    {
      // At a third, a half and two thirds between knots in s.
      const double s = (k / 3 + (2 + k % 3) / 6.0) / n;
      const double depth = range * s * s;
      const double h = 1e-4 * depth;
      const auto force = [&](double d) { return sampling.evaluate(samples, range, d).force; };
      const double slope = (8.0 * (force(depth + h) - force(depth - h)) -
                             (force(depth + 2.0 * h) - force(depth - 2.0 * h))) /
        (12.0 * h);
      // Differences of fourth order: truncation (h/δ)⁴ n⁴ F/δ = 1e-12, rounding 1e-16 F/h = 1e-12
      // F/δ, and 1e-16·50⁴ in the power law at the start with q up to 50.
      EXPECT_NEAR(sampling.evaluate(samples, range, depth).stiffness, slope,
        1e-9 * (std::abs(slope) + samples.forces.back() / depth));
    }
  }
}
