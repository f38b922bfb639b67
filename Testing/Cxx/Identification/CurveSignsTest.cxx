// SPDX-License-Identifier: BSD-3-Clause
// Curves with wrong signs or units are rejected with a message and are never identified.
#include "Identification/CurveSigns.h"
#include "Identification/MeasuredSite.h"

#include "TestTools.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace curve_signs
{
using palpate::MeasuredCurve;
using palpate::MeasuredSite;
using palpate::testing::tool;

namespace
{
constexpr double Modulus = 0.05; // E*, MPa

/// Hertz's paraboloid of 3 mm, pressed in by 0.4 mm after an approach of 0.2 mm, and released if
/// `isReleased`.
MeasuredCurve press(bool isReleased, double noise = 5e-5)
{
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  MeasuredCurve curve;
  for (int i = 0; i <= (isReleased ? 120 : 60); ++i)
  {
    const double depth = 0.01 * (i <= 60 ? i : 120 - i) - 0.2;
    curve.deflection.push_back(0.01 * (i <= 60 ? i : 120 - i) + 1.0);
    curve.force.push_back(
      4.0 / 3.0 * Modulus * std::sqrt(3.0) * std::pow(std::max(depth, 0.0), 1.5) +
      noise * normal(random));
  }
  return curve;
}

MeasuredSite identified(const MeasuredCurve& curve)
{
  MeasuredSite site;
  site.curves.push_back({ "paraboloid:3", tool("paraboloid:3"), curve, {} });
  palpate::identifySite({}, palpate::BodyIdentification({}), site);
  return site;
}

MeasuredCurve times(MeasuredCurve curve, double deflection, double force)
{
  for (std::size_t i = 0; i < curve.force.size(); ++i)
  {
    curve.deflection[i] *= deflection;
    curve.force[i] *= force;
  }
  return curve;
}

/// Expects a refusal that contains all of `words`.
void refuse(const MeasuredCurve& curve, std::initializer_list<const char*> words)
{
  const std::string refusal = identified(curve).refusal;
  for (const char* word : words)
  {
    EXPECT_NE(refusal.find(word), std::string::npos) << word << " in: " << refusal;
  }
}
} // namespace

TEST(CurveSigns, WhatRisesIsIdentified)
{
  for (const bool isReleased : { false, true })
  {
    const MeasuredSite site = identified(press(isReleased));
    EXPECT_EQ(site.refusal, "");
    EXPECT_LE(site.body.reducedModulus.lower, Modulus);
    EXPECT_GE(site.body.reducedModulus.upper, Modulus);
  }
}

TEST(CurveSigns, CompressionThatIsNegativeIsAsked)
{
  for (const bool isReleased : { false, true })
  {
    const MeasuredCurve curve = press(isReleased);
    refuse(times(curve, 1.0, -1.0),
      { "forces fall", "is compression negative here", "negative: force" });
    refuse(times(curve, -1.0, 1.0), { "deflection falls", "forces rise", "negative: deflection" });
    refuse(times(curve, -1.0, -1.0), { "both negative", "negative: deflection, force" });
  }
  // The message states the range of the readings: 4/3 0.05 √3 0.4^1.5 = 0.0292 N, without the last
  // two readings (0.01 mm apart), which may be outliers.
  refuse(times(press(false, 0.0), 1.0, -1.0), { "from 0 to -0.027", "from 1 to 1.58 mm" });
}

TEST(CurveSigns, AWrongReadingIsNoSign)
{
  for (const double outlier : { -5.0, 5.0 })
  {
    MeasuredCurve curve = press(false);
    curve.force[10] = outlier;
    EXPECT_EQ(palpate::doubtSigns(curve), "");
  }
}

TEST(CurveSigns, DeflectionsInOtherUnitsAreAsked)
{
  refuse(times(press(false), 1e3, 1.0),
    { "beyond first contact", "paraboloid:3", "is it in um", "deflection_um" });
  refuse(times(press(false), 1e6, 1.0), { "is it in nm", "deflection_nm" });
}

TEST(CurveSigns, AForceThatDoesNotRiseIsNoBody)
{
  std::mt19937 random(8);
  std::normal_distribution<double> normal;
  MeasuredCurve noise = press(false);
  for (double& force : noise.force)
  {
    force = 1e-3 * normal(random);
  }
  EXPECT_NE(identified(noise).refusal, "");
  for (double& force : noise.force)
  {
    force = 0.7;
  }
  refuse(noise, { "the force stays at 0.7 N" });
}
} // namespace curve_signs
