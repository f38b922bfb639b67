// SPDX-License-Identifier: BSD-3-Clause
// The part of a curve before the contact: long, with an offset, with a drift, or curved. The
// reference is Hertz's closed form.
#include "Identification/ArrangedReadings.h"
#include "Identification/BodyIdentification.h"
#include "Identification/MeasuredSite.h"

#include "BaselineCurves.h"
#include "EstimateHolds.h"
#include "TestTools.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace force_baseline
{
using palpate::BodyIdentification;
using palpate::BodyModel;
using palpate::IdentificationOptions;
using palpate::IdentifiedBody;
using palpate::IndentationCurve;
using palpate::testing::Approach;
using palpate::testing::holds;
using palpate::testing::tool;

namespace
{
Approach approach(double length, int before, double offset, double drift)
{
  Approach made;
  made.length = length;
  made.before = before;
  made.offset = offset;
  made.drift = drift;
  return made;
}

BodyIdentification halfSpace()
{
  IdentificationOptions options;
  options.model = BodyModel::HalfSpace;
  return BodyIdentification(options);
}

double halfWidth(const palpate::Estimate& estimate)
{
  return 0.5 * (estimate.upper - estimate.lower);
}
} // namespace

/// 95 % intervals contain the true value 95 times in 100. For 200 repeats three standard deviations
/// of the binomial are allowed, 3 √(0.95 0.05/200) = 4.6 %. IdentificationCoverage has 2000
/// repeats.
TEST(ForceBaseline, IntervalsHoldTheTruth)
{
  constexpr int repeats = 200;
  const auto tip = tool("paraboloid:3");
  const BodyIdentification identification = halfSpace();
  for (const Approach& made : { approach(5.0, 5000, 0.0, 0.0), approach(1.0, 200, 0.02, 0.0),
         approach(0.1, 20, 0.0, 0.02), approach(1.0, 200, -0.01, -0.03) })
  {
    std::mt19937 random(2026);
    int modulus = 0;
    int contact = 0;
    int offset = 0;
    int drift = 0;
    for (int i = 0; i < repeats; ++i)
    {
      const IdentifiedBody body = identification.identify({ made.measure(*tip, random) });
      ASSERT_EQ(body.refusal, "");
      const double unit = Approach::force(Approach::Depth);
      modulus += holds(body.reducedModulus, Approach::Modulus) ? 1 : 0;
      contact += holds(body.contactOffset[0], made.length) ? 1 : 0;
      // The offset is that at the estimated contact.
      offset +=
        holds(body.forceOffset[0], unit * (made.offset + made.drift * body.baseline[0].reference))
        ? 1
        : 0;
      drift += holds(body.forceDrift[0], unit * made.drift) ? 1 : 0;
    }
    for (const int held : { modulus, contact, offset, drift })
    {
      EXPECT_NEAR(held / static_cast<double>(repeats), 0.95, 0.046)
        << made.before << " readings before, " << made.offset << " + " << made.drift << " per mm";
    }
  }
}

/// Curves with the same noise and with an offset, a drift, or a baseline of another length.
TEST(ForceBaseline, ChangesTheModulusByLessThanItsInterval)
{
  const auto tip = tool("paraboloid:3");
  const BodyIdentification identification({});
  const auto identify = [&](const Approach& made)
  {
    std::mt19937 random(7);
    return identification.identify({ made.measure(*tip, random) });
  };
  const IdentifiedBody plain = identify(approach(1.0, 200, 0.0, 0.0));
  ASSERT_EQ(plain.refusal, "");
  for (const Approach& made : { approach(1.0, 200, 0.02, 0.0), approach(1.0, 200, 0.0, 0.02),
         approach(1.0, 200, 0.0, -0.03), approach(1.0, 200, -3.0, 0.02),
         approach(5.0, 5000, 0.0, 0.0), approach(50.0, 20000, 0.0, 0.002) })
  {
    const IdentifiedBody body = identify(made);
    ASSERT_EQ(body.refusal, "") << made.offset << " " << made.drift << " " << made.length;
    // noise and drift must not be identified as a layer
    EXPECT_EQ(body.body.model, BodyModel::HalfSpace);
    EXPECT_TRUE(body.withinNoise);
    EXPECT_TRUE(holds(body.reducedModulus, Approach::Modulus));
    EXPECT_LT(std::abs(body.reducedModulus.value - plain.reducedModulus.value),
      halfWidth(plain.reducedModulus));
    // Without a fit of the baseline the uncertainty of E* is 0.2 %. With the fit it is at most
    // twice as large.
    EXPECT_LT(halfWidth(body.reducedModulus), 2.0 * halfWidth(plain.reducedModulus));
  }
}

/// Readings are averaged over equal intervals of depth, for any number and position of readings
/// before the contact.
TEST(ForceBaseline, ReadingsAreGroupedByDepth)
{
  const auto tip = tool("paraboloid:3");
  std::mt19937 random(3);
  IndentationCurve curve = approach(5.0, 5000, 0.0, 0.0).measure(*tip, random);
  // 50000 readings while the tool waits before the approach
  curve.deflection.insert(curve.deflection.begin(), 50000, 0.0);
  curve.force.insert(curve.force.begin(), 50000, 0.0);
  const IndentationCurve arranged = arrangeReadings(curve, true);
  EXPECT_NEAR(arranged.start.depth, 5.0, 0.05);
  EXPECT_EQ(arranged.start.terms, palpate::BaselineTerms::OffsetAndDrift);
  double readings = 0.0;
  int inContact = 0;
  for (std::size_t i = 0; i < arranged.force.size(); ++i)
  {
    inContact += arranged.deflection[i] >= 5.0 ? 1 : 0;
    readings += arranged.readings[i];
  }
  // Each reading in contact is its own group, because the readings are 1/80 of the depth apart and
  // a group is 1/145 of the depth. The first one is grouped with readings before the contact.
  EXPECT_EQ(inContact, 80);
  EXPECT_LE(arranged.force.size(), 200U);
  // readings before the contact count over four times the depth of contact; they are 0.001 mm apart
  EXPECT_NEAR(readings, 81 + 1600, 100);
}

TEST(ForceBaseline, WhatIsNoBaselineIsRefused)
{
  const auto tip = tool("paraboloid:3");
  std::mt19937 random(5);
  IndentationCurve crooked = approach(1.0, 200, 0.0, 0.0).measure(*tip, random);
  for (std::size_t i = 0; i < 200; ++i)
  {
    crooked.force[i] +=
      0.1 * Approach::force(Approach::Depth) * std::sin(0.1 * static_cast<double>(i));
  }
  const BodyIdentification identification = halfSpace();
  const std::string refusal = identification.identify({ crooked }).refusal;
  EXPECT_NE(refusal.find("no model fits"), std::string::npos) << refusal;
  // The largest accepted drift changes the force by a tenth of its maximum over the depth of
  // contact: 0.25 of the maximum per mm.
  for (const double drift : { 0.2, 0.4 })
  {
    const IdentifiedBody body =
      identification.identify({ approach(1.0, 200, 0.0, drift).measure(*tip, random) });
    EXPECT_EQ(body.refusal.find("not a baseline") != std::string::npos, drift > 0.25)
      << body.refusal;
  }
}

/// The energy of a loop is computed from the force without its offset, so a loop that loses 5 %
/// counts as elastic for any offset.
TEST(ForceBaseline, DoesNotCountAsALoop)
{
  for (const double offset : { 0.0, -0.5, 0.5 })
  {
    std::mt19937 random(11);
    palpate::MeasuredSite site;
    palpate::MeasuredCurve curve;
    const IndentationCurve load =
      approach(1.0, 200, offset, 0.0).measure(*tool("paraboloid:3"), random);
    curve.deflection = load.deflection;
    curve.force = load.force;
    for (std::size_t i = load.force.size() - 1; i-- > 0;)
    {
      const double kept = 0.05 * Approach::force(load.deflection[i] - 1.0);
      curve.deflection.push_back(load.deflection[i]);
      curve.force.push_back(load.force[i] - kept);
    }
    site.curves.push_back({ "paraboloid:3", tool("paraboloid:3"), curve, {} });
    palpate::identifySite({}, halfSpace(), site);
    ASSERT_EQ(site.refusal, "") << offset;
    // The offset is accurate to 0.01 % of the largest force. The branches end within 1 % of the
    // turning point.
    EXPECT_NEAR(site.curves[0].prepared.hysteresis, 0.05, 0.005) << offset;
    EXPECT_TRUE(holds(site.body.reducedModulus, Approach::Modulus));
  }
}

/// With too few readings before the contact the drift is taken as 0, and the remark states this.
TEST(ForceBaseline, SaysWhatItDoesNotTell)
{
  const auto tip = tool("paraboloid:3");
  std::mt19937 random(5);
  const auto remark = [&](const Approach& made)
  {
    const IdentifiedBody body = halfSpace().identify({ made.measure(*tip, random) });
    EXPECT_EQ(body.refusal, "");
    EXPECT_TRUE(holds(body.reducedModulus, Approach::Modulus));
    return body.remark;
  };
  EXPECT_EQ(remark(approach(1.0, 200, 0.0, 0.0)), "");
  EXPECT_NE(remark(approach(0.05, 10, 0.01, 0.0)).find("drift"), std::string::npos);
  EXPECT_NE(remark(approach(0.01, 2, 0.0, 0.0)).find("offset"), std::string::npos);
}
} // namespace force_baseline
