// SPDX-License-Identifier: BSD-3-Clause
// A curve with capped stiffness, against fine quadrature of the data contract (ContractCurve) and
// against the capped curves of three tools (Mahvash and Hayward 2002).
#include "Contact/CappedResponse.h"

#include "SampleResponses.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace palpate::testing;
using palpate::BlendedResponse;
using palpate::CappedResponse;
using palpate::Infinity;
using palpate::NotANumber;
using palpate::ResponseField;
using palpate::ResponseValue;
using palpate::Vector3;

namespace
{
const palpate::TriangleCorners Corners{ 0, 1, 2 };

/// Three points with one law each, F = scale δ^power.
ResponseStore powerLaws(const std::array<double, 3>& scales, double power,
  const std::array<float, 3>& ranges = { 2.0F, 2.0F, 2.0F })
{
  ResponseStore store(3);
  for (std::size_t p = 0; p < 3; ++p)
  {
    store.range[p] = ranges[p];
    for (std::size_t i = 0; i < 8; ++i)
    {
      const double depth =
        static_cast<double>(ranges[p]) * static_cast<double>((i + 1) * (i + 1)) / 64.0;
      store.force[8 * p + i] = static_cast<float>(scales[p] * std::pow(depth, power));
      store.stiffness[8 * p + i] =
        static_cast<float>(scales[p] * power * std::pow(depth, power - 1.0));
    }
  }
  return store;
}

/// ∫ min(dF/dδ, K_max) of the blended curves up to each of the increasing depths, by the midpoint
/// rule in x = √δ.
std::vector<double> quadrature(const ResponseStore& store, const Vector3& weights, double maximum,
  const std::vector<double>& depths)
{
  const std::array<ContractCurve, 3> curves{ store.curveOf(0), store.curveOf(1), store.curveOf(2) };
  std::vector<double> sums;
  double sum = 0.0;
  double from = 0.0;
  for (const double depth : depths)
  {
    const double to = std::sqrt(depth);
    const int intervals = 1 + static_cast<int>((to - from) / 5e-4);
    const double h = (to - from) / intervals;
    for (int i = 0; i < intervals; ++i)
    {
      const double x = from + (i + 0.5) * h;
      double stiffness = 0.0;
      for (std::size_t k = 0; k < 3; ++k)
      {
        stiffness += weights[static_cast<Eigen::Index>(k)] * curves[k].evaluate(x * x).stiffness;
      }
      sum += std::min(stiffness, maximum) * 2.0 * x * h;
    }
    from = to;
    sums.push_back(sum);
  }
  return sums;
}

/// Largest difference from the quadrature, relative to K_max δ.
double worstShare(const ResponseStore& store, const Vector3& weights, double maximum)
{
  const ResponseField field(store.arrays());
  const CappedResponse capped(BlendedResponse(field, Corners, weights), maximum);
  std::vector<double> depths;
  for (double depth = 0.02; depth < 3.0; depth += 0.0471)
  {
    depths.push_back(depth);
  }
  const std::vector<double> expected = quadrature(store, weights, maximum, depths);
  double worst = 0.0;
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    const double error = capped.evaluate(depths[i]).force - std::max(0.0, expected[i]);
    worst = std::max(worst, std::abs(error) / (maximum * depths[i]));
  }
  return worst;
}
} // namespace

TEST(CappedResponse, ClosedFormOfTheSphere)
{
  // F = c δ^1.5 reaches K_max at δ* = (K_max/1.5c)². For larger depths F_c = c δ*^1.5 + K_max (δ -
  // δ*).
  const ResponseStore store = powerLaws({ 10.0, 10.0, 10.0 }, 1.5);
  const ResponseField field(store.arrays());
  const BlendedResponse response(field, Corners, Vector3(0.2, 0.3, 0.5));
  for (const double maximum : { 0.02, 0.5, 2.0, 11.0, 20.0 })
  {
    const CappedResponse capped(response, maximum);
    const double turn = std::pow(maximum / 15.0, 2.0);
    for (const double depth : { 1e-5, 1e-4, 0.01, 0.3, 1.0, 1.9, 2.0 })
    {
      const bool isCapped = depth > turn;
      const double expected = isCapped ? 10.0 * std::pow(turn, 1.5) + maximum * (depth - turn)
                                       : 10.0 * std::pow(depth, 1.5);
      const double stiffness = isCapped ? maximum : 15.0 * std::sqrt(depth);
      const ResponseValue value = capped.evaluate(depth);
      // The accuracy that the header states, and float32 samples: 6e-8 of F.
      EXPECT_NEAR(value.force, expected, 1e-7 * maximum * depth + 2e-7 * expected) << maximum;
      EXPECT_NEAR(value.stiffness, stiffness, 2e-7 * stiffness) << maximum << ' ' << depth;
      EXPECT_FALSE(value.beyondRange);
      EXPECT_NEAR(capped.share(depth) * response.evaluate(depth).force, value.force, 1e-14);
    }
  }
}

TEST(CappedResponse, QuadratureOfMonotoneStiffness)
{
  // Three ranges and scales. The stiffness rises or falls, depending on the power; with 0.8 it
  // falls from infinity. With h = 5e-4 the midpoint rule has an error of h²/(4 δ) times K_max δ at
  // the bend: 3e-6.
  for (const double power : { 0.8, 1.0, 1.2, 1.5, 2.0, 3.0 })
  {
    const ResponseStore store = powerLaws({ 4.0, 10.0, 25.0 }, power, { 1.1F, 2.0F, 1.6F });
    for (const Vector3& weights : { Vector3(0.2, 0.3, 0.5), Vector3(1.0, 0.0, 0.0) })
    {
      for (const double maximum : { 0.3, 2.0, 40.0 })
      {
        EXPECT_LE(worstShare(store, weights, maximum), 5e-6) << power << ' ' << maximum;
      }
    }
  }
}

TEST(CappedResponse, QuadratureOfAnyStiffness)
{
  // Random samples with three random ranges: the stiffness rises and falls within every cell, even
  // below zero. In the worst case intervals above the cap between two nodes are missed, 2 % of
  // K_max δ. In most cases none is missed.
  int exact = 0;
  int cases = 0;
  for (unsigned seed = 1; seed <= 10; ++seed)
  {
    ResponseStore store(3);
    store.randomizeCurves(seed);
    for (const double maximum : { 0.5, 2.0, 6.0 })
    {
      const double error = worstShare(store, Vector3(0.2, 0.3, 0.5), maximum);
      EXPECT_LE(error, 0.03) << seed << ' ' << maximum;
      exact += error <= 5e-5;
      ++cases;
    }
  }
  EXPECT_GE(2 * exact, cases);
}

TEST(CappedResponse, ContinuousAndNeverSteeper)
{
  ResponseStore store(3);
  store.randomizeCurves(5);
  const ResponseField field(store.arrays());
  const double step = 1e-4;
  for (const double maximum : { 0.5, 3.0 })
  {
    const CappedResponse capped(BlendedResponse(field, Corners, Vector3(0.2, 0.3, 0.5)), maximum);
    double last = 0.0;
    for (double depth = step; depth < 6.0; depth += step)
    {
      const ResponseValue value = capped.evaluate(depth);
      EXPECT_LE(value.stiffness, maximum);
      // The end of an interval is found to 1e-7 of K_max δ, so F_c has a step of at most this size.
      // In a missed interval between nodes the slope is that of F, at most 10 N/mm here.
      ASSERT_LE(value.force - last, 10.0 * step + 1e-6 * maximum * depth) << depth;
      ASSERT_GE(value.force - last, -20.0 * step - 1e-6 * maximum * depth) << depth;
      last = value.force;
    }
  }
}

TEST(CappedResponse, ThePapersTools)
{
  // In rubber (E* = 3.45 MPa) at 1 mm the three tools have 11.41, 11.04 and 5.45 N, and with a cap
  // of 2 N/mm 1.99, 2.00 and 1.96 N. F reaches the stiffness of the cap, 2 E* a, at 0.0132, 0 and
  // 0.0529 mm (at first contact a sphere is as stiff as a paraboloid), with 0.0176, 0 and 0.0706 N.
  constexpr double rubber = 3.45;
  const auto capped = [](const ResponseStore& store)
  {
    const ResponseField field(store.arrays());
    return CappedResponse(BlendedResponse(field, Corners, Vector3(1.0, 0.0, 0.0)), 2.0)
      .evaluate(1.0)
      .force;
  };
  const auto sphere = [&](double radius)
  {
    const double scale = 4.0 / 3.0 * rubber * std::sqrt(radius);
    return powerLaws({ scale, scale, scale }, 1.5);
  };
  const double flat = 2.0 * rubber * 1.6;
  // The values of the paper are rounded to 0.01 N.
  EXPECT_NEAR(capped(sphere(6.35)), 1.99, 0.005);
  EXPECT_NEAR(capped(powerLaws({ flat, flat, flat }, 1.0)), 2.00, 0.005);
  EXPECT_NEAR(capped(sphere(1.6)), 1.96, 0.005);
}

TEST(CappedResponse, LimitsThatAreNone)
{
  ResponseStore store(3);
  store.randomizeCurves(3);
  const ResponseField field(store.arrays());
  const BlendedResponse response(field, Corners, Vector3(0.2, 0.3, 0.5));
  for (const double depth : { 0.01, 0.7, 1.3, 5.0 })
  {
    const ResponseValue whole = response.evaluate(depth);
    const ResponseValue uncapped = CappedResponse(response, Infinity).evaluate(depth);
    EXPECT_EQ(uncapped.force, whole.force);
    EXPECT_EQ(uncapped.stiffness, whole.stiffness);
    EXPECT_EQ(uncapped.beyondRange, whole.beyondRange);
    EXPECT_EQ(CappedResponse(response, Infinity).share(depth), 1.0);
    for (const double none : { 0.0, -1.0, NotANumber, -Infinity })
    {
      EXPECT_LE(CappedResponse(response, none).evaluate(depth).force, 1e-12) << none;
    }
  }
  // A cap above every stiffness has no effect.
  const ResponseField spheres(powerLaws({ 4.0, 10.0, 25.0 }, 1.5).arrays());
  const BlendedResponse sphere(spheres, Corners, Vector3(0.2, 0.3, 0.5));
  EXPECT_EQ(CappedResponse(sphere, 1e3).evaluate(1.9).force, sphere.evaluate(1.9).force);
  const CappedResponse capped(response, 2.0);
  for (const double depth : { 0.0, -1.0, NotANumber })
  {
    EXPECT_EQ(capped.evaluate(depth).force, 0.0);
    EXPECT_EQ(capped.evaluate(depth).stiffness, 0.0);
    EXPECT_EQ(capped.share(depth), 1.0);
  }
  // all weights zero, as without a contact
  const BlendedResponse nowhere(field, Corners, Vector3::Zero());
  EXPECT_EQ(CappedResponse(nowhere, 2.0).evaluate(1.0).force, 0.0);
}

TEST(CappedResponse, AStiffnessKnownToRiseIsCappedAsAnyOther)
{
  // The same curves in a field with a fourth, unused point whose stiffness falls.
  for (const double power : { 1.5, 1.7, 2.0 })
  {
    const ResponseStore store = powerLaws({ 4.0, 10.0, 25.0 }, power, { 1.1F, 2.0F, 1.6F });
    const ResponseField known(store.arrays());
    ASSERT_TRUE(known.hasRisingStiffness());
    ResponseStore withAnother(4);
    std::copy(store.force.begin(), store.force.end(), withAnother.force.begin());
    std::copy(store.stiffness.begin(), store.stiffness.end(), withAnother.stiffness.begin());
    std::copy(store.range.begin(), store.range.end(), withAnother.range.begin());
    withAnother.stiffness[8 * 3 + 4] = 0.1F;
    const ResponseField unknown(withAnother.arrays());
    ASSERT_FALSE(unknown.hasRisingStiffness());
    const Vector3 weights(0.2, 0.3, 0.5);
    for (const double maximum : { 0.02, 0.3, 2.0, 11.0, 40.0, 200.0 })
    {
      const CappedResponse one(BlendedResponse(known, Corners, weights), maximum);
      const CappedResponse other(BlendedResponse(unknown, Corners, weights), maximum);
      for (double depth = 1e-5; depth < 12.0; depth *= 1.07)
      {
        const ResponseValue value = one.evaluate(depth);
        // Both have the accuracy that the header states.
        EXPECT_NEAR(value.force, other.evaluate(depth).force, 2e-7 * maximum * depth)
          << power << ' ' << maximum << ' ' << depth;
        EXPECT_EQ(value.stiffness, other.evaluate(depth).stiffness);
        EXPECT_LE(std::abs(one.share(depth) - other.share(depth)), 2e-7);
      }
    }
  }
}

TEST(CappedResponse, NeverPulls)
{
  // The force rises by 8 N, starting at 16 N/mm, and falls again. Capped at 1 N/mm, the fall is
  // larger than the rise.
  ResponseStore store(3);
  for (std::size_t p = 0; p < 3; ++p)
  {
    for (std::size_t i = 0; i < 8; ++i)
    {
      const double depth = 2.0 * static_cast<double>((i + 1) * (i + 1)) / 64.0;
      store.force[8 * p + i] = static_cast<float>(16.0 * depth - 8.0 * depth * depth);
      store.stiffness[8 * p + i] = static_cast<float>(16.0 - 16.0 * depth);
    }
  }
  const ResponseField field(store.arrays());
  const CappedResponse capped(BlendedResponse(field, Corners, Vector3(0.2, 0.3, 0.5)), 1.0);
  // K > 1 up to 15/16 mm, where F_c is 15/16 N. Beyond this depth F_c changes as F does.
  for (const double depth : { 0.3, 0.9, 1.0, 1.2, 1.5, 1.9 })
  {
    const double turn = 15.0 / 16.0;
    const double rest = 16.0 * (depth - turn) - 8.0 * (depth * depth - turn * turn);
    // The interpolant is a function of δ^1.5. It differs from a parabola by 1e-4 of 8 N.
    EXPECT_NEAR(
      capped.evaluate(depth).force, std::max(0.0, depth < turn ? depth : turn + rest), 2e-3);
  }
  EXPECT_EQ(capped.evaluate(1.9).force, 0.0);
}
