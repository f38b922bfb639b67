// SPDX-License-Identifier: BSD-3-Clause
// Checks that 95 % confidence intervals of relaxing bodies contain the true value 95 times in 100:
// repeated experiments with noise of 1 % of the largest force and an unknown contact point, with
// fixed seeds. The forces are those of Lee and Radok for a ramp and a hold, and of Ting for a
// triangle.
#include "Identification/RelaxingIdentification.h"

#include "Mechanics/Numerics/Constants.h"

#include "ClosedRelaxation.h"
#include "EstimateHolds.h"
#include "TestTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

using palpate::BodyIdentification;
using palpate::IdentificationOptions;
using palpate::MeasuredCurve;
using palpate::PronySeries;
using namespace palpate::testing;

namespace
{
constexpr double Offset = 0.2; // mm

struct Tally
{
  int chosen = 0; ///< repeats in which the right number of branches was chosen
  int modulus = 0;
  int offset = 0;
  std::array<int, PronySeries::LargestCount> strength{};
  std::array<int, PronySeries::LargestCount> time{};
  std::vector<double> worst; ///< largest relative error of E* ψ over the window, for each repeat
};

/// Repeats the measurement of `clean` with noise of a hundredth of its largest force.
Tally repeat(const char* specification, double modulus, const PronySeries& truth,
  const MeasuredCurve& clean, bool isNoiseGiven, int repeats)
{
  const auto tip = tool(specification);
  const double noise = 0.01 * *std::max_element(clean.force.begin(), clean.force.end());
  IdentificationOptions options;
  options.model = palpate::BodyModel::HalfSpace;
  options.largestUncertainty = 10.0; // large, so that every interval is checked
  options.largestStrain = 100.0;     // large, because the true law is linear at every depth
  options.noise = isNoiseGiven ? noise : 0.0;
  const BodyIdentification identification(options);
  std::mt19937 random(1966);
  std::normal_distribution<double> normal;
  Tally tally;
  for (int i = 0; i < repeats; ++i)
  {
    MeasuredCurve curve = clean;
    for (double& force : curve.force)
    {
      force += noise * normal(random);
    }
    palpate::PreparedCurve prepared;
    palpate::prepareCurve(curve, {}, prepared);
    const auto found =
      identifyRelaxing(identification, { palpate::makeHistory(*tip, curve, prepared, true) });
    EXPECT_EQ(found.refusal, "");
    if (found.relaxation.count != truth.count)
    {
      continue;
    }
    ++tally.chosen;
    tally.modulus += holds(found.reducedModulus, modulus) ? 1 : 0;
    tally.offset += holds(found.contactOffset[0], Offset) ? 1 : 0;
    double worst = 0.0;
    for (double t = found.shortestTime; t <= found.longestTime; t *= 1.2)
    {
      const double ratio = found.reducedModulus.value * relaxationAt(found.relaxation, t) /
        (modulus * relaxationAt(truth, t));
      worst = std::max(worst, std::abs(ratio - 1.0));
    }
    tally.worst.push_back(worst);
    for (std::size_t k = 0; k < truth.count; ++k)
    {
      tally.strength[k] += holds(found.relaxationStrength[k], truth.strength[k]) ? 1 : 0;
      tally.time[k] += holds(found.relaxationTime[k], truth.time[k]) ? 1 : 0;
    }
  }
  return tally;
}

/// Expects 95 % of `count`, within three standard deviations of the binomial (4.6 % for 200).
void expectNinetyFive(int held, int count, const std::string& what)
{
  const double share = static_cast<double>(held) / count;
  std::printf("  %-12s %d of %d: %.1f %%\n", what.c_str(), held, count, 100.0 * share);
  EXPECT_NEAR(share, 0.95, 3.0 * std::sqrt(0.95 * 0.05 / count)) << what;
}

void check(const char* specification, double modulus, const PronySeries& truth,
  const MeasuredCurve& clean, bool isNoiseGiven, int repeats)
{
  Tally tally = repeat(specification, modulus, truth, clean, isNoiseGiven, repeats);
  // The choice is a likelihood-ratio test at 1 %, computed with few elements.
  EXPECT_GE(tally.chosen, 0.95 * repeats);
  int all = tally.modulus + tally.offset;
  expectNinetyFive(tally.modulus, tally.chosen, "E*");
  expectNinetyFive(tally.offset, tally.chosen, "offset");
  for (std::size_t k = 0; k < truth.count; ++k)
  {
    const std::string branch = std::to_string(k + 1);
    expectNinetyFive(tally.strength[k], tally.chosen, "strength " + branch);
    expectNinetyFive(tally.time[k], tally.chosen, "time " + branch);
    all += tally.strength[k] + tally.time[k];
  }
  // All parameters together: 93 to 97 %, plus one standard deviation of the binomial, 1.5 % for 200
  // repeats. The parameters of a repeat are correlated.
  const double share =
    static_cast<double>(all) / (tally.chosen * static_cast<double>(2 + 2 * truth.count));
  std::nth_element(
    tally.worst.begin(), tally.worst.begin() + tally.worst.size() / 2, tally.worst.end());
  const double worst = tally.worst[tally.worst.size() / 2];
  std::printf("  together %.1f %%; median of the worst error of E* psi: %.2f %%\n", 100.0 * share,
    100.0 * worst);
  EXPECT_NEAR(share, 0.95, 0.02 + std::sqrt(0.95 * 0.05 / repeats));
  EXPECT_LT(worst, 0.015);
}

MeasuredCurve heldCurve(const RampAndHold& test)
{
  std::mt19937 random(1);
  return timedCurve(rampAndHoldTimes(test.ramp, 10.0, 100, 400), test, Offset, 0.0, random);
}
} // namespace

TEST(RelaxationCoverage, RampAndHold)
{
  RampAndHold test;
  test.series.add(0.6, 0.1);
  test.series.add(0.4, 2.0);
  check("paraboloid:6.35", 0.75 / std::sqrt(6.35), test.series, heldCurve(test), false, 200);
}

TEST(RelaxationCoverage, RampAndHoldOfAFlat)
{
  RampAndHold test;
  test.series.add(1.0, 0.3);
  test.m = 1.0;
  check("flat:1", 0.5, test.series, heldCurve(test), true, 200);
}

TEST(RelaxationCoverage, Triangle)
{
  const palpate::testing::Triangle test{ 1.0, 0.3, 2.0, 1.0, 1.0, 1.0 };
  std::mt19937 random(1);
  const MeasuredCurve clean = timedCurve(evenTimes(2.0, 300), test, Offset, 0.0, random);
  PronySeries truth;
  truth.add(test.p, test.tau);
  check("cone:45", 0.5 * palpate::Pi, truth, clean, false, 500);
}
