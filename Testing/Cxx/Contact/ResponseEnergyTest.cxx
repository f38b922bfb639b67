// SPDX-License-Identifier: BSD-3-Clause
// The work of a stored response, against quadrature of the data contract (ContractCurve) and
// against closed forms.
#include "Contact/ResponseSampling.h"

#include "ContractCurve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using palpate::ResponseEnergy;
using palpate::ResponseSampling;
using palpate::testing::ContractCurve;

namespace
{
/// A curve in the form that the kernel reads.
struct SamplesOfCurve
{
  const ContractCurve& curve;
  double force(int i) const { return curve.force[static_cast<std::size_t>(i)]; }
  double stiffness(int i) const { return curve.stiffness[static_cast<std::size_t>(i)]; }
};

double energyOf(const ContractCurve& curve, double depth)
{
  const ResponseSampling sampling(static_cast<int>(curve.force.size()), curve.exponent);
  return ResponseEnergy(sampling).energy(SamplesOfCurve{ curve }, curve.range, depth);
}

ContractCurve anyCurve(int n, double exponent, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  ContractCurve curve{ exponent, 1.0 + share(random), {}, {} };
  double sum = 0.0;
  for (int i = 0; i < n; ++i)
  {
    sum += 0.05 + share(random);
    curve.force.push_back(sum / n);
    curve.stiffness.push_back(0.5 + 3.0 * share(random));
  }
  return curve;
}

ContractCurve powerLaw(int n, double exponent, double range)
{
  ContractCurve curve{ exponent, range, {}, {} };
  for (int i = 1; i <= n; ++i)
  {
    const double depth = range * i * i / (n * n);
    curve.force.push_back(10.0 * std::pow(depth, exponent));
    curve.stiffness.push_back(10.0 * exponent * std::pow(depth, exponent - 1.0));
  }
  return curve;
}

/// ∫F over [a, b] within one interval of the curve, by Simpson's rule on 100 intervals of x = √δ.
/// In x every interval is smooth except the power law at the start.
double quadrature(const ContractCurve& curve, double a, double b)
{
  constexpr int intervals = 100;
  const double from = std::sqrt(a);
  const double h = (std::sqrt(b) - from) / intervals;
  long double sum = 0.0L;
  for (int i = 0; i <= intervals; ++i)
  {
    const double x = from + i * h;
    const double weight = i == 0 || i == intervals ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    sum += static_cast<long double>(weight * 2.0 * x * curve.evaluate(x * x).force);
  }
  return static_cast<double>(sum * static_cast<long double>(h / 3.0));
}
} // namespace

TEST(ResponseEnergy, ClosedFormOfPowerLaws)
{
  for (const double m : { 1.0, 1.5, 2.0, 1.37 })
  {
    for (const int n : { 2, 8, 256 })
    {
      const ContractCurve curve = powerLaw(n, m, 2.0);
      for (double depth = 1e-7; depth < 2.0; depth *= 1.7)
      {
        const double expected = 10.0 * std::pow(depth, m + 1.0) / (m + 1.0);
        // Integration by parts cancels in a cell, which is 1/i of the whole: n³/(p+4)… times
        // rounding.
        EXPECT_NEAR(energyOf(curve, depth), expected, 1e-11 * expected) << n << " " << m;
      }
      const double whole = 10.0 * std::pow(2.0, m + 1.0) / (m + 1.0);
      EXPECT_NEAR(energyOf(curve, 2.0), whole, 1e-11 * whole);
      // Beyond the range the force is the tangent.
      const double force = 10.0 * std::pow(2.0, m);
      const double stiffness = 10.0 * m * std::pow(2.0, m - 1.0);
      EXPECT_NEAR(energyOf(curve, 2.7), whole + 0.7 * force + 0.245 * stiffness, 1e-11 * whole);
    }
  }
}

TEST(ResponseEnergy, QuadratureOfTheContract)
{
  for (const int n : { 2, 5, 8, 31 })
  {
    for (const double m : { 1.0, 1.5, 1.8 })
    {
      const ContractCurve curve = anyCurve(n, m, static_cast<unsigned>(n));
      // From the first sample on. The start is a closed form, which is tested below.
      const double first = curve.range / (n * n);
      double sum = 0.0;
      for (int i = 1; i < n; ++i)
      {
        const double a = curve.range * i * i / (n * n);
        const double b = curve.range * (i + 1) * (i + 1) / (n * n);
        for (const double depth : { 0.7 * a + 0.3 * b, 0.01 * a + 0.99 * b, b })
        {
          const double expected = sum + quadrature(curve, a, depth);
          // Error of Simpson's rule: (width/100)^4 times a fourth derivative of about 1e4 times the
          // values of the cell.
          EXPECT_NEAR(energyOf(curve, depth) - energyOf(curve, first), expected, 1e-7);
        }
        sum += quadrature(curve, a, b);
      }
      const double beyond = curve.range * 1.4;
      EXPECT_NEAR(energyOf(curve, beyond) - energyOf(curve, curve.range),
        quadrature(curve, curve.range, beyond), 1e-10);
    }
  }
}

TEST(ResponseEnergy, ItsSlopeIsTheForce)
{
  // At all depths, also across samples: there are no jumps.
  const double e = 1e-5;
  for (unsigned seed = 1; seed < 6; ++seed)
  {
    const ContractCurve curve = anyCurve(8, 1.5, seed);
    for (double depth = 0.003; depth < 1.5 * curve.range; depth += 0.0113)
    {
      const double slope = (energyOf(curve, depth + e) - energyOf(curve, depth - e)) / (2.0 * e);
      // Error of the difference: e²/6 times the second derivative of the force, which is < 1e4
      // N/mm² near the start. Where this derivative jumps, the error is e times the jump: below
      // 1e-6 N.
      EXPECT_NEAR(slope, curve.evaluate(depth).force, 1e-6 * (1.0 + slope));
    }
  }
}

TEST(ResponseEnergy, PowerStartAndItsLimits)
{
  ContractCurve curve = anyCurve(8, 1.5, 9);
  const double first = curve.range / 64.0;
  const double q = curve.stiffness[0] * first / curve.force[0];
  const double whole = curve.force[0] * first / (q + 1.0);
  for (const double share : { 1e-9, 0.01, 0.5, 0.999 })
  {
    EXPECT_NEAR(energyOf(curve, share * first), whole * std::pow(share, q + 1.0), 1e-13 * whole);
  }
  EXPECT_NEAR(energyOf(curve, first), whole, 1e-14 * whole);
  curve.force[0] = 0.0; // no force before the first sample
  EXPECT_EQ(energyOf(curve, 0.5 * first), 0.0);
  EXPECT_EQ(energyOf(curve, first), 0.0);
  EXPECT_EQ(energyOf(curve, 0.0), 0.0);
  EXPECT_EQ(energyOf(curve, -1.0), 0.0);
  EXPECT_TRUE(std::isnan(energyOf(curve, std::numeric_limits<double>::quiet_NaN())));
}
