// SPDX-License-Identifier: BSD-3-Clause
// Bodies identified from curves of independent formulas, and curves that are rejected.
#include "Identification/BodyIdentification.h"

#include "Identification/ForceNoise.h"
#include "Mechanics/Layers/LayerContact.h"

#include "Agreement.h"
#include "SyntheticCurves.h"
#include "TestTools.h"

using palpate::BodyIdentification;
using palpate::BodyModel;
using palpate::IdentificationOptions;
using palpate::IdentifiedBody;
using palpate::IndentationCurve;
using namespace palpate::testing;

namespace
{
constexpr double Modulus = 0.05; // MPa
constexpr double R = 6.35;

IndentationCurve series(const palpate::AxisymmetricTool& tool, double compliance,
  const Readings& readings, unsigned seed = 1)
{
  std::mt19937 random(seed);
  return makeCurve(
    tool, [=](double d) { return hertzInSeries(R, Modulus, compliance, d); }, readings, random);
}
} // namespace

TEST(BodyIdentification, FindsAHalfSpaceAndItsContactPointExactly)
{
  const auto tip = tool("paraboloid:6.35");
  Readings readings;
  readings.offset = 0.37;
  const IdentifiedBody body = BodyIdentification({}).identify({ series(*tip, 0.0, readings) });
  ASSERT_EQ(body.refusal, "");
  EXPECT_EQ(body.body.model, BodyModel::HalfSpace);
  EXPECT_TRUE(body.withinNoise);
  EXPECT_TRUE(
    agrees(body.reducedModulus.value, Modulus, 1e-8)); // end criterion of Levenberg and Marquardt
  EXPECT_NEAR(body.contactOffset[0].value, 0.37, 1e-8);
  // The data end at the last reading within small strain: a/R <= 0.4, which is δ <= 0.16 R.
  const double step = readings.depth / readings.count / 0.85;
  const double end = (std::floor(0.16 * R / step - 0.5) + 0.5) * step;
  EXPECT_TRUE(agrees(body.endForce, 4.0 / 3.0 * Modulus * std::sqrt(R) * std::pow(end, 1.5), 1e-7));
  EXPECT_TRUE(agrees(body.endStiffness, 2.0 * Modulus * std::sqrt(R * end), 1e-7));
}

TEST(BodyIdentification, FindsTheGlobalCompliance)
{
  const auto tip = tool("paraboloid:6.35");
  for (const double compliance : { 1.0, 10.0 })
  {
    const IdentifiedBody body =
      BodyIdentification({}).identify({ series(*tip, compliance, Readings{}) });
    ASSERT_EQ(body.refusal, "") << compliance;
    EXPECT_EQ(body.body.model, BodyModel::GlobalCompliance);
    // The fit ends at relative steps of 1e-11. An error of E* is compensated by C_g, which
    // multiplies it by about 100.
    EXPECT_TRUE(agrees(body.reducedModulus.value, Modulus, 1e-6));
    EXPECT_TRUE(agrees(body.compliance.value, compliance, 1e-6));
    EXPECT_NEAR(body.contactOffset[0].value, 0.0, 1e-7);
  }
}

TEST(BodyIdentification, FindsTheLayer)
{
  const auto tip = tool("sphere:6.35");
  const auto kernel = std::make_shared<const palpate::LayerKernel>(0.5, palpate::LayerBase::Bonded);
  for (const double thickness : { 4.0, 10.0 })
  {
    const palpate::LayerContact layer(*tip, kernel, thickness);
    std::mt19937 random(1);
    Readings readings;
    readings.offset = -0.2;
    const IdentifiedBody body = BodyIdentification({}).identify({ makeCurve(
      *tip, [&](double d) { return layer.evaluate(d, Modulus).force; }, readings, random) });
    ASSERT_EQ(body.refusal, "") << thickness;
    EXPECT_EQ(body.body.model, BodyModel::Layer);
    // same tolerance as with a compliance
    EXPECT_TRUE(agrees(body.reducedModulus.value, Modulus, 1e-6));
    EXPECT_TRUE(agrees(body.thickness.value, thickness, 1e-6));
    EXPECT_NEAR(body.contactOffset[0].value, -0.2, 1e-7);
  }
}

TEST(BodyIdentification, RefusesAFlatAlone)
{
  const auto flat = tool("flat:1.6");
  std::mt19937 random(5);
  Readings readings;
  readings.noise = 0.001;
  const auto law = [](double d) { return 2.0 * 1.6 * Modulus * d; };
  for (const double noise : { 0.0, 0.001 })
  {
    readings.noise = noise;
    const IndentationCurve curve = makeCurve(*flat, law, readings, random);
    const IdentifiedBody body = BodyIdentification({}).identify({ curve });
    EXPECT_NE(body.refusal.find("flat punch"), std::string::npos) << body.refusal;
    for (const BodyModel model : { BodyModel::GlobalCompliance, BodyModel::Layer })
    {
      IdentificationOptions options;
      options.model = model;
      const IdentifiedBody forced = BodyIdentification(options).identify({ curve });
      EXPECT_NE(forced.refusal.find("flat punch"), std::string::npos) << forced.refusal;
    }
    IdentificationOptions halfSpace;
    halfSpace.model = BodyModel::HalfSpace;
    const IdentifiedBody body2 = BodyIdentification(halfSpace).identify({ curve });
    EXPECT_EQ(body2.refusal, "");
    // noise of 0.001 N of 0.24 N, 60 readings
    EXPECT_NEAR(body2.reducedModulus.value, Modulus, 0.02 * Modulus);
  }
  // Two loads with the same punch give no more information than one.
  const IndentationCurve again = makeCurve(*flat, law, readings, random);
  const IdentifiedBody twice = BodyIdentification({}).identify({ again, again });
  EXPECT_NE(twice.refusal.find("flat punch"), std::string::npos) << twice.refusal;
}

TEST(BodyIdentification, AFlatAndASphereTogetherTellTheCompliance)
{
  const auto flat = tool("flat:1.6");
  const auto tip = tool("paraboloid:6.35");
  const double compliance = 4.0;
  std::mt19937 random(5);
  const double local = 2.0 * 1.6 * Modulus;
  Readings readings;
  readings.offset = 0.1;
  const IdentifiedBody body = BodyIdentification({}).identify(
    { makeCurve(
        *flat, [=](double d) { return local * d / (1.0 + local * compliance); }, readings, random),
      series(*tip, compliance, Readings{}) });
  ASSERT_EQ(body.refusal, "");
  EXPECT_EQ(body.body.model, BodyModel::GlobalCompliance);
  EXPECT_TRUE(agrees(body.compliance.value, compliance, 1e-6));
  ASSERT_EQ(body.contactOffset.size(), 2U);
  EXPECT_NEAR(body.contactOffset[0].value, 0.1, 1e-6);
  EXPECT_NEAR(body.contactOffset[1].value, 0.0, 1e-6);
}

TEST(BodyIdentification, RefusesWhatNoBodyGives)
{
  const auto tip = tool("paraboloid:6.35");
  std::mt19937 random(9);
  // The stiffness falls with the depth, which is impossible for an elastic body under a rounded
  // tip.
  const IndentationCurve yielding = makeCurve(
    *tip, [](double d) { return std::sqrt(d); }, Readings{}, random);
  const IdentifiedBody body = BodyIdentification({}).identify({ yielding });
  EXPECT_NE(body.refusal.find("no model fits"), std::string::npos) << body.refusal;

  IndentationCurve few = series(*tip, 0.0, Readings{});
  few.deflection.resize(7);
  few.force.resize(7);
  EXPECT_NE(
    BodyIdentification({}).identify({ few }).refusal.find("7 readings; 8"), std::string::npos);
  IndentationCurve pull = series(*tip, 0.0, Readings{});
  for (double& force : pull.force)
  {
    force = -std::abs(force);
  }
  EXPECT_NE(
    BodyIdentification({}).identify({ pull }).refusal.find("does not increase"), std::string::npos);
  EXPECT_NE(BodyIdentification({}).identify({}).refusal, "");
}

TEST(BodyIdentification, RefusesWhatNoiseHides)
{
  // 40 readings with noise of a tenth of the largest force. If C_g is unknown as well, E* cannot be
  // determined.
  const auto tip = tool("paraboloid:6.35");
  Readings readings;
  readings.count = 40;
  readings.noise = 0.03;
  const IdentifiedBody body = BodyIdentification({}).identify({ series(*tip, 0.0, readings) });
  EXPECT_NE(body.refusal.find("E*"), std::string::npos) << body.refusal;
  // Small strain ends at a depth of 1.016 mm of 1.5 mm.
  EXPECT_NE(body.refusal.find("of 40 readings are not used"), std::string::npos) << body.refusal;
}

TEST(BodyIdentification, ManyReadingsAreGrouped)
{
  const auto tip = tool("paraboloid:6.35");
  Readings readings;
  readings.count = 20000;
  readings.noise = 0.003; // 1 % of the largest force
  const IdentifiedBody body = BodyIdentification({}).identify({ series(*tip, 3.0, readings) });
  ASSERT_EQ(body.refusal, "");
  EXPECT_EQ(body.body.model, BodyModel::GlobalCompliance);
  EXPECT_NEAR(body.noise, 0.003, 0.03 * 0.003);  // error of the median of 20000 values: 1 %
  EXPECT_NEAR(body.misfit, 0.003, 0.15 * 0.003); // error of the mean of 200 groups: 5 %
  EXPECT_LT(body.compliance.lower, 3.0);
  EXPECT_GT(body.compliance.upper, 3.0);
}

TEST(ForceNoise, IsFoundUnderTheCurve)
{
  const auto tip = tool("paraboloid:6.35");
  double sum = 0.0;
  const int repeats = 200;
  Readings readings;
  readings.noise = 0.002;
  for (int i = 0; i < repeats; ++i)
  {
    const IndentationCurve curve = series(*tip, 0.0, readings, static_cast<unsigned>(i));
    const auto noise = palpate::estimateForceNoise(curve.deflection, curve.force);
    EXPECT_EQ(noise.degreesOfFreedom, 15.0);
    sum += noise.deviation / readings.noise;
  }
  // The mean of 200 values, each with a standard deviation of √(1/2·15) = 18 %, has one of 1.3 %;
  // three of them are allowed. The median of 57 values has an error of 1 to 2 %.
  EXPECT_NEAR(sum / repeats, 1.0, 0.06);
}
