// SPDX-License-Identifier: BSD-3-Clause
// Curves whose energies have closed forms: F = k δ in loading, so W = k δ²/2.
#include "Identification/CurvePreparation.h"

#include "Agreement.h"

#include <gtest/gtest.h>

#include <random>

using palpate::CurvePhase;
using palpate::MeasuredCurve;
using palpate::prepareCurve;
using palpate::PreparedCurve;
using palpate::testing::agrees;

namespace
{
constexpr int Steps = 100;
constexpr double Depth = 2.0; // mm

/// Appends a straight part between two depths at `speed` mm/s, with F = stiffness × depth. It
/// contains the last reading, but not the first.
void run(MeasuredCurve& curve, double from, double to, double stiffness, double speed = 1.0)
{
  const double start = curve.time.empty() ? 0.0 : curve.time.back();
  for (int i = 1; i <= Steps; ++i)
  {
    const double deflection = from + (to - from) * i / Steps;
    curve.deflection.push_back(deflection);
    curve.force.push_back(stiffness * deflection);
    curve.time.push_back(start + std::abs(deflection - from) / speed);
  }
}

/// A loop that loses the fraction `share` of the energy. The unloading is a straight line below the
/// loading: F = k' δ with k' = (1 - share) k.
MeasuredCurve cycle(double share, double stiffness = 3.0)
{
  MeasuredCurve curve;
  run(curve, 0.0, Depth, stiffness);
  run(curve, Depth, 0.0, (1.0 - share) * stiffness);
  return curve;
}
} // namespace

TEST(CurvePreparation, SeparatesTheLoadingAndMeasuresHysteresis)
{
  for (const double share : { 0.0, 0.05, 0.19 })
  {
    PreparedCurve prepared;
    EXPECT_EQ(prepareCurve(cycle(share), {}, prepared), "");
    ASSERT_EQ(prepared.loads.size(), 1U);
    EXPECT_EQ(prepared.loads[0].deflection.size(), static_cast<std::size_t>(Steps));
    EXPECT_EQ(prepared.loads[0].deflection.back(), Depth);
    // Both branches are straight. The step from one to the other at the turning point, 1 % of the
    // depth, belongs to neither branch.
    EXPECT_NEAR(prepared.hysteresis, share, 2e-3);
    EXPECT_TRUE(agrees(prepared.loads[0].speed, 1.0, 1e-12));
  }
}

TEST(CurvePreparation, RefusesWhatIsNotElastic)
{
  PreparedCurve prepared;
  const std::string lossy = prepareCurve(cycle(0.3), {}, prepared);
  EXPECT_NE(lossy.find("hysteresis"), std::string::npos) << lossy;
  EXPECT_NE(lossy.find("20.0 %"), std::string::npos) << lossy;
  EXPECT_NEAR(prepared.hysteresis, 0.3, 4e-3); // same tolerance as for the branches above
  EXPECT_EQ(prepared.loads.size(), 1U);
  EXPECT_EQ(prepareCurve(cycle(0.3), { 0.4, 0.1 }, prepared), "");
  const std::string gains =
    prepareCurve(cycle(-0.3), {}, prepared); // the loop returns more energy than it received
  EXPECT_NE(gains.find("hysteresis"), std::string::npos) << gains;
}

TEST(CurvePreparation, ComparesSpeeds)
{
  // Two loads at one site. The second is ten times as fast and stiffer by a factor s. The
  // difference of the energies k δ²/2, relative to their mean, is 2 (s-1)/(s+1).
  for (const double stiffer : { 1.0, 1.05, 1.3 })
  {
    MeasuredCurve curve;
    run(curve, 0.0, Depth, 3.0, 1.0);
    run(curve, Depth, 0.0, 3.0, 10.0);
    run(curve, 0.0, Depth, 3.0 * stiffer, 10.0);
    PreparedCurve prepared;
    const std::string refusal = prepareCurve(curve, {}, prepared);
    ASSERT_EQ(prepared.loads.size(), 2U);
    EXPECT_NEAR(prepared.rateEffect, 2.0 * (stiffer - 1.0) / (stiffer + 1.0), 1e-3);
    EXPECT_EQ(refusal.find("speed") != std::string::npos, stiffer > 1.2) << refusal;
  }
  MeasuredCurve same;
  run(same, 0.0, Depth, 3.0);
  run(same, Depth, 0.0, 3.0);
  run(same, 0.0, Depth, 4.0);
  PreparedCurve prepared;
  prepareCurve(same, {}, prepared);
  EXPECT_TRUE(std::isnan(prepared.rateEffect)); // one speed does not show the effect of the rate
  same.time.clear();
  prepareCurve(same, {}, prepared);
  EXPECT_TRUE(std::isnan(prepared.rateEffect));
}

TEST(CurvePreparation, FindsBranchesThroughNoiseAndHold)
{
  MeasuredCurve curve;
  run(curve, 0.0, Depth, 3.0);
  for (int i = 0; i < 50; ++i) // a hold during which the force relaxes
  {
    curve.deflection.push_back(Depth);
    curve.force.push_back(3.0 * Depth - 0.04 * i);
    curve.time.push_back(curve.time.back() + 0.1);
  }
  run(curve, Depth, 0.0, 2.6);
  run(curve, 0.0, Depth, 3.0);
  std::mt19937 random(3);
  // 0.002 mm: a tenth of the step between readings
  std::normal_distribution<double> noise(0.0, 0.002);
  for (double& deflection : curve.deflection)
  {
    deflection += noise(random);
  }
  PreparedCurve prepared;
  EXPECT_EQ(prepareCurve(curve, {}, prepared), "");
  ASSERT_EQ(prepared.loads.size(), 2U);
  for (const auto& load : prepared.loads)
  {
    EXPECT_NEAR(static_cast<double>(load.force.size()), Steps, 3.0);
    for (std::size_t i = 0; i < load.force.size(); ++i)
    {
      // Readings of the hold are up to 2 N lower. 0.03 N is 5 standard deviations of the
      // deflection, times the stiffness.
      EXPECT_NEAR(load.force[i], 3.0 * load.deflection[i], 0.03);
    }
  }
}

TEST(CurvePreparation, TakesThePhasesWhereRecorded)
{
  MeasuredCurve curve = cycle(0.1);
  curve.phase.assign(curve.deflection.size(), CurvePhase::Loading);
  std::fill(curve.phase.begin() + Steps - 10, curve.phase.begin() + Steps, CurvePhase::Hold);
  std::fill(curve.phase.begin() + Steps, curve.phase.end(), CurvePhase::Unloading);
  PreparedCurve prepared;
  EXPECT_EQ(prepareCurve(curve, {}, prepared), "");
  ASSERT_EQ(prepared.loads.size(), 1U);
  EXPECT_EQ(prepared.loads[0].force.size(), static_cast<std::size_t>(Steps - 10));
}

TEST(CurvePreparation, RefusesCurvesWithoutLoading)
{
  PreparedCurve prepared;
  MeasuredCurve curve;
  EXPECT_NE(prepareCurve(curve, {}, prepared).find("no loading"), std::string::npos);
  run(curve, Depth, 0.0, 1.0);
  EXPECT_NE(prepareCurve(curve, {}, prepared).find("no loading"), std::string::npos);
  curve.phase.assign(curve.deflection.size(), CurvePhase::Unloading);
  EXPECT_NE(prepareCurve(curve, {}, prepared).find("no loading"), std::string::npos);
  MeasuredCurve still;
  still.deflection.assign(20, 1.0);
  still.force.assign(20, 1.0);
  EXPECT_NE(prepareCurve(still, {}, prepared).find("no loading"), std::string::npos);
}
