// SPDX-License-Identifier: BSD-3-Clause
// The material of a body: constants and values, and invalid combinations.
#include "Laws/BodyMaterial.h"

#include "Paraboloid.h"
#include "Laws/ResponseLaw.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

using namespace palpate;

namespace
{
const BodyMaterial::Constants Usual = { 0.1, 0.45, 0.0, LayerBase::Bonded, false };

std::string take(BodyMaterial::Constants constants, BodyMaterial::Values values, std::size_t points)
{
  return BodyMaterial(constants).take(std::move(values), points);
}

void expectNames(const std::string& fault, std::initializer_list<const char*> words)
{
  for (const char* word : words)
  {
    EXPECT_NE(fault.find(word), std::string::npos) << fault;
  }
}
} // namespace

TEST(BodyMaterial, ConstantsHoldWhereThereAreNoValues)
{
  BodyMaterial material(Usual);
  BodyMaterial::Values values;
  values.compliance = { "C", { 1.0, 2.0 } };
  ASSERT_EQ(material.take(std::move(values), 2), "");
  const ContactSpot spot = material.spots().at(1);
  EXPECT_DOUBLE_EQ(spot.reducedModulus, 0.1 / (1.0 - 0.45 * 0.45));
  EXPECT_EQ(spot.poissonRatio, 0.45);
  EXPECT_EQ(spot.compliance, 2.0);
  EXPECT_EQ(spot.thickness, 0.0);
  EXPECT_EQ(material.describe(), "half-space in series with global compliance");
}

TEST(BodyMaterial, ValuesOverrideEach)
{
  BodyMaterial material(Usual);
  BodyMaterial::Values values;
  values.youngsModulus = { "E", { 0.2, 0.3 } };
  values.poissonRatio = { "nu", { 0.0, 0.5 } };
  values.thickness = { "h", { 0.0, 4.0 } };
  ASSERT_EQ(material.take(std::move(values), 2), "");
  EXPECT_DOUBLE_EQ(material.spots().at(0).reducedModulus, 0.2);
  EXPECT_DOUBLE_EQ(material.spots().at(1).reducedModulus, 0.4);
  EXPECT_EQ(material.spots().at(1).thickness, 4.0);
  EXPECT_EQ(material.range().layers.poissonRatios, (std::vector<double>{ 0.5 }));
  EXPECT_EQ(material.describe(), "layer bonded to a rigid base of varying thickness");
}

TEST(BodyMaterial, WrongConstantsAreNamed)
{
  const auto check = [](double young, double poisson, double thickness) {
    return BodyMaterial({ young, poisson, thickness, LayerBase::Bonded, false }).checkConstants();
  };
  EXPECT_EQ(check(0.1, 0.45, 1.0), "");
  expectNames(check(0.0, 0.45, 0.0), { "Young's Modulus", "MPa", "0" });
  expectNames(check(0.1, 0.51, 0.0), { "Poisson's Ratio", "0.51" });
  expectNames(check(0.1, 0.45, -1.0), { "Layer Thickness", "-1" });
}

TEST(BodyMaterial, AWrongValueIsNamedWithItsPoint)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BodyMaterial::Values values;
  values.youngsModulus = { "E", { 0.1, -3.0 } };
  expectNames(take(Usual, values, 2), { "'E'", "point 1", "-3" });
  values = {};
  values.poissonRatio = { "nu", { 0.7, 0.1 } };
  expectNames(take(Usual, values, 2), { "'nu'", "point 0", "0.7" });
  values = {};
  values.thickness = { "h", { 1.0, nan } };
  expectNames(take(Usual, values, 2), { "'h'", "point 1", "nan" });
  values = {};
  values.compliance = { "C", { 1.0, std::numeric_limits<double>::infinity() } };
  expectNames(take(Usual, values, 2), { "'C'", "point 1", "inf" });
  values = {};
  values.thickness = { "h", { 1.0, 2.0 } };
  values.thicknessError = { "hError", { 0.1, -0.2 } };
  expectNames(take(Usual, values, 2), { "'hError'", "point 1", "-0.2", "1/mm" });
}

TEST(BodyMaterial, ABaseIsNotCountedTwice)
{
  BodyMaterial::Values values;
  values.compliance = { "C", { 1.0 } };
  BodyMaterial::Constants layered = Usual;
  layered.thickness = 3.0;
  expectNames(
    take(layered, values, 1), { "Layer Thickness 3", "'C'", "Compliance Excludes Layer" });
  layered.complianceExcludesLayer = true;
  EXPECT_EQ(take(layered, values, 1), "");
}

TEST(BodyMaterial, TheExponentIsTheTipsUntilTheBodyIsSoft)
{
  const auto tool = palpate::testing::Paraboloid{}.make();
  const ResponseLaw law(*tool, 2.0, 8);
  BodyMaterial hard(Usual);
  ASSERT_EQ(hard.take({}, 1), "");
  EXPECT_EQ(hard.bestExponent(*tool, law), 1.5);
  BodyMaterial soft(Usual);
  BodyMaterial::Values values;
  values.compliance = { "C", { 1000.0 } }; // mm/N: the body acts almost as a spring
  ASSERT_EQ(soft.take(std::move(values), 1), "");
  EXPECT_EQ(soft.bestExponent(*tool, law), 1.0);
}
