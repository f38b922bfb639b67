// SPDX-License-Identifier: BSD-3-Clause
// Curves of kinds that instruments record and that no model fits. Each is rejected with a message,
// and a failed fit is never used. The forces of holds are those of Lee and Radok.
#include "Identification/MeasuredSite.h"

#include "ClosedRelaxation.h"
#include "TestTools.h"

#include <gtest/gtest.h>

#include <optional>

namespace failed_fit
{
using palpate::BodyModel;
using palpate::IdentificationOptions;
using palpate::MeasuredCurve;
using palpate::MeasuredSite;
using palpate::testing::RampAndHold;
using palpate::testing::tool;

namespace
{
/// A sphere of 5 mm, pressed 4 mm into a material whose force has the given exponent of the depth,
/// and held.
MeasuredCurve pressAndHold(double exponent, double noise = 0.002, unsigned seed = 1)
{
  RampAndHold press;
  press.m = exponent;
  press.depth = 4.0;
  press.ramp = 4.0;
  press.c = 0.6 / std::pow(press.depth, exponent);
  press.series.add(1.0, 0.5);
  press.series.add(0.6, 4.0);
  std::mt19937 random(seed);
  return timedCurve(palpate::testing::evenTimes(14.0, 140), press, 0.5, noise, random);
}

MeasuredSite identified(
  const MeasuredCurve& curve, std::optional<BodyModel> model = BodyModel::HalfSpace)
{
  IdentificationOptions options;
  options.model = model;
  MeasuredSite site;
  site.curves.push_back({ "sphere:5", tool("sphere:5"), curve, {} });
  palpate::identifySite({}, palpate::BodyIdentification(options), site);
  return site;
}

MeasuredCurve from(const MeasuredCurve& curve, std::size_t first)
{
  MeasuredCurve rest;
  const auto skip = static_cast<std::ptrdiff_t>(first);
  rest.deflection.assign(curve.deflection.begin() + skip, curve.deflection.end());
  rest.force.assign(curve.force.begin() + skip, curve.force.end());
  rest.time.assign(curve.time.begin() + skip, curve.time.end());
  return rest;
}
} // namespace

TEST(FailedFit, HoldsAreRefusedInWords)
{
  for (const double exponent : { 1.0, 2.5, 3.5 }) // a sphere on a half-space has the exponent 1.5
  {
    for (const unsigned seed : { 1U, 2U })
    {
      const MeasuredSite site = identified(pressAndHold(exponent, 0.002, seed));
      EXPECT_NE(site.refusal, "") << exponent;
      EXPECT_TRUE(std::isnan(site.body.reducedModulus.value)) << exponent;
    }
  }
}

/// Curves with a load before the first reading, strong noise, few readings or a drift.
TEST(FailedFit, WhateverComesIsIdentifiedOrRefused)
{
  std::vector<MeasuredCurve> curves;
  const MeasuredCurve plain = pressAndHold(2.5);
  curves.push_back(from(plain, 20)); // the curve begins at 0.1 of the depth
  curves.push_back(from(plain, 50)); // the curve begins in the hold
  curves.push_back(pressAndHold(2.5, 0.3));
  curves.push_back(pressAndHold(2.5, 10.0));
  MeasuredCurve drifting = plain;
  MeasuredCurve down = plain;
  for (std::size_t i = 0; i < plain.force.size(); ++i)
  {
    drifting.force[i] += 0.1 * plain.deflection[i];
    down.force[i] = -plain.force[i];
  }
  curves.push_back(drifting);
  curves.push_back(down);
  for (const MeasuredCurve& curve : curves)
  {
    const MeasuredSite site = identified(curve);
    EXPECT_NE(site.refusal.empty(), std::isnan(site.body.reducedModulus.value)) << site.refusal;
  }
}

/// The stiffness grows faster with depth than on a half-space, so C_g would be negative.
TEST(FailedFit, ANegativeComplianceIsNoBody)
{
  MeasuredCurve stiffening;
  for (int i = -20; i <= 60; ++i)
  {
    const double depth = 0.01 * i;
    stiffening.deflection.push_back(depth);
    stiffening.force.push_back(i < 0 ? 0.0 : 0.1 * std::pow(depth, 1.7));
  }
  const MeasuredSite site = identified(stiffening, BodyModel::GlobalCompliance);
  EXPECT_NE(site.refusal.find("fitted global compliance is -"), std::string::npos) << site.refusal;
  EXPECT_NE(site.refusal.find("stiffen more than a half-space"), std::string::npos) << site.refusal;
  EXPECT_TRUE(std::isnan(site.body.reducedModulus.value));
}
} // namespace failed_fit
