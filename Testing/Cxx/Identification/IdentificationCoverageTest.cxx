// SPDX-License-Identifier: BSD-3-Clause
// Checks that 95 % confidence intervals contain the true value 95 times in 100: repeated
// experiments with noise of 1 % of the largest force and an unknown contact point, with fixed
// seeds. Also checks how often the right model is chosen, and the interval of the force predicted
// for another tool.
#include "Identification/PredictedForceError.h"

#include "Mechanics/Layers/LayerContact.h"

#include "BaselineCurves.h"
#include "EstimateHolds.h"
#include "SyntheticCurves.h"
#include "TestTools.h"

#include <gtest/gtest.h>

using palpate::BodyIdentification;
using palpate::BodyModel;
using palpate::IdentificationOptions;
using namespace palpate::testing;

namespace
{
constexpr double Modulus = 0.05;   // MPa
constexpr double Offset = 0.2;     // mm
constexpr double OtherDepth = 1.0; // depth of the other tool, mm

struct Truth
{
  BodyModel model;
  double second; ///< C_g, mm/N, or the thickness h, mm
};

struct Tally
{
  int modulus = 0;
  int second = 0;
  int offset = 0;
  int felt = 0; ///< intervals of the other tool's force that contain the true force
  int chosen = 0;
};

Tally repeat(const palpate::AxisymmetricTool& tip, const Truth& truth, int repeats, int readings,
  bool noiseGiven, bool modelGiven)
{
  IdentificationOptions options;
  options.largestUncertainty = 10.0; // large, so that every interval is checked
  options.largestStrain = 100.0;     // large, because the true law is linear at every depth
  if (modelGiven)
  {
    options.model = truth.model;
  }
  const auto kernel = std::make_shared<const palpate::LayerKernel>(0.5, palpate::LayerBase::Bonded);
  palpate::BodyParameters body{ truth.model, Modulus, 0.0, 0.0 };
  (truth.model == BodyModel::Layer ? body.thickness : body.compliance) = truth.second;
  const auto law = [&](double depth)
  { return palpate::bodyResponse(body, tip, kernel, depth).force; };
  Readings sampling;
  sampling.count = readings;
  sampling.offset = Offset;
  sampling.noise = 0.01 * law(sampling.depth);
  options.noise = noiseGiven ? sampling.noise : 0.0;
  const BodyIdentification identification(options);
  const auto other = tool("flat:1.6");
  const double force = palpate::bodyResponse(body, *other, kernel, OtherDepth).force;
  std::mt19937 random(2002);
  Tally tally;
  for (int i = 0; i < repeats; ++i)
  {
    const auto found = identification.identify({ makeCurve(tip, law, sampling, random) });
    if (!found.refusal.empty() || found.body.model != truth.model)
    {
      continue;
    }
    ++tally.chosen;
    tally.modulus += holds(found.reducedModulus, Modulus) ? 1 : 0;
    tally.offset += holds(found.contactOffset[0], Offset) ? 1 : 0;
    tally.second += truth.model == BodyModel::HalfSpace ||
        holds(truth.model == BodyModel::Layer ? found.thickness : found.compliance, truth.second)
      ? 1
      : 0;
    const double felt = palpate::bodyResponse(found.body, *other, kernel, OtherDepth).force;
    const double error = palpate::predictedForceError(found, *other, kernel, OtherDepth);
    tally.felt += std::abs(std::log(felt / force)) <= error ? 1 : 0;
  }
  return tally;
}

/// Expects 95 % of `count`, within three standard deviations of the binomial and 2 % for the error
/// of the linearised problem.
void expectNinetyFive(int held, int count, const char* what)
{
  const double share = static_cast<double>(held) / count;
  const double slack = 3.0 * std::sqrt(0.95 * 0.05 / count) + 0.02;
  std::printf("  %-10s %d of %d: %.1f %%\n", what, held, count, 100.0 * share);
  EXPECT_NEAR(share, 0.95, slack) << what;
}

void check(const char* specification, const Truth& truth, int repeats, int choices)
{
  const auto tip = tool(specification);
  for (const bool noiseGiven : { true, false })
  {
    const Tally tally = repeat(*tip, truth, repeats, 80, noiseGiven, true);
    ASSERT_EQ(tally.chosen, repeats) << "refused";
    expectNinetyFive(tally.modulus, repeats, "E*");
    expectNinetyFive(tally.second, repeats, "C_g or h");
    expectNinetyFive(tally.offset, repeats, "offset");
    expectNinetyFive(tally.felt, repeats, "felt");
  }
  // With a free choice of the model, the two tests at 1 % reject the true model rarely: three
  // standard deviations are allowed.
  const Tally free = repeat(*tip, truth, choices, 80, false, false);
  std::printf("  chosen     %d of %d\n", free.chosen, choices);
  EXPECT_GE(free.chosen, 0.9 * choices);
}
} // namespace

TEST(IdentificationCoverage, HalfSpace)
{
  check("paraboloid:6.35", { BodyModel::HalfSpace, 0.0 }, 400, 40);
}

TEST(IdentificationCoverage, GlobalCompliance)
{
  check("paraboloid:6.35", { BodyModel::GlobalCompliance, 6.0 }, 400, 40);
}

/// Curves with readings before the contact, 2000 repeats: 93 to 97 %, which is four standard
/// deviations of the binomial, 0.49 %. With a free choice of the model, the two tests at 1 % rarely
/// reject the half-space.
TEST(IdentificationCoverage, Baselines)
{
  constexpr int repeats = 2000;
  constexpr int choices = 60;
  const auto tip = tool("paraboloid:3");
  IdentificationOptions options;
  options.model = BodyModel::HalfSpace;
  const BodyIdentification halfSpace(options);
  const BodyIdentification any({});
  for (const Approach& made :
    { Approach{ 5.0, 5000, 80, 0.0, 0.0 }, Approach{ 1.0, 200, 80, 0.02, 0.0 },
      Approach{ 1.0, 200, 80, 0.0, 0.02 }, Approach{ 1.0, 200, 80, 0.0, -0.02 },
      Approach{ 0.3, 60, 80, 0.0, 0.02 }, Approach{ 5.0, 5000, 1000, 0.0, 0.02 } })
  {
    std::mt19937 random(2026);
    int held = 0;
    for (int i = 0; i < repeats; ++i)
    {
      const auto found = halfSpace.identify({ made.measure(*tip, random) });
      ASSERT_EQ(found.refusal, "");
      held += holds(found.reducedModulus, Approach::Modulus) ? 1 : 0;
    }
    const double share = static_cast<double>(held) / repeats;
    int chosen = 0;
    for (int i = 0; i < choices; ++i)
    {
      const auto found = any.identify({ made.measure(*tip, random) });
      chosen += found.refusal.empty() && found.body.model == BodyModel::HalfSpace ? 1 : 0;
    }
    std::printf("  %d readings over %g mm before, drift %g: %.1f %%, chosen %d of %d\n",
      made.before, made.length, made.drift, 100.0 * share, chosen, choices);
    EXPECT_NEAR(share, 0.95, 0.02);
    EXPECT_GE(chosen, 0.95 * choices);
  }
}

TEST(IdentificationCoverage, Layer)
{
  check("sphere:6.35", { BodyModel::Layer, 5.0 }, 60, 10);
}
