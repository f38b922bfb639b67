// SPDX-License-Identifier: BSD-3-Clause
// Local share of the deflection and effect of the tool's size, in cases with known results.
#include "Laws/RegimeLaw.h"

#include "Paraboloid.h"
#include "Contact/ResponseField.h"
#include "Laws/BodyMaterial.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>

namespace regime_law
{
using namespace palpate;
using palpate::testing::Paraboloid;

namespace
{
constexpr double Deepest = 2.0; // mm
// the central difference over ±1 % of the size has an error of 2e-5
constexpr double Central = 1e-4;
} // namespace

TEST(RegimeLaw, AHalfSpaceIsLocal)
{
  const Paraboloid paraboloid;
  const auto tool = paraboloid.make();
  const RegimeLaw law(*tool, MaterialRange(LayerBase::Bonded), Deepest);
  ASSERT_TRUE(law.complete());
  const ContactSpot spot{ 0.06, 0.45, 0.0, 0.0 };
  const double force = law.force(spot, 1.0);
  EXPECT_NEAR(force, paraboloid.force(1.0, 0.06), 1e-12);
  const SpotRegime found = law.regime(spot, 1.0, force);
  EXPECT_NEAR(found.index, 0.0, 1e-9);
  EXPECT_NEAR(found.sensitivity, 0.5, Central); // F ∝ √R
  EXPECT_EQ(found.verdict, RegimeVerdict::ShapeMatters);
}

TEST(RegimeLaw, AFlatIsAsStiffAsItIsWide)
{
  const auto tool = makeTool({ ToolShape::Flat, 3.0 });
  const RegimeLaw law(*tool, MaterialRange(LayerBase::Bonded), Deepest);
  const ContactSpot spot{ 0.06, 0.45, 0.0, 0.0 };
  EXPECT_NEAR(law.regime(spot, 1.0, law.force(spot, 1.0)).sensitivity, 1.0, Central);
}

TEST(RegimeLaw, ASoftBodyTakesTheDepthUponItself)
{
  const auto tool = Paraboloid{}.make();
  const RegimeLaw law(*tool, MaterialRange(LayerBase::Bonded), Deepest);
  const double compliance = 400.0; // mm/N, as of a long strip
  const ContactSpot spot{ 0.06, 0.45, compliance, 0.0 };
  const double force = law.force(spot, 1.0);
  const SpotRegime found = law.regime(spot, 1.0, force);
  EXPECT_NEAR(found.index, compliance * force, 1e-9); // C F/δ
  // dlnF/dlnR with the compliance in series: ½/(1 + 1.5 C F/δ_local).
  const double local = 1.0 - compliance * force;
  EXPECT_NEAR(found.sensitivity, 0.5 / (1.0 + 1.5 * compliance * force / local), Central);
  EXPECT_EQ(found.verdict, RegimeVerdict::PointForceSuffices);
}

TEST(RegimeLaw, WithoutAStableContactItIsNotKnown)
{
  const auto tool = Paraboloid{}.make();
  const RegimeLaw law(*tool, MaterialRange(LayerBase::Bonded), Deepest);
  const ContactSpot spot{ 0.06, 0.45, -20.0, 0.0 };
  const SpotRegime found = law.regime(spot, 2.0, law.force(spot, 2.0));
  EXPECT_TRUE(std::isnan(found.index));
  EXPECT_EQ(found.verdict, RegimeVerdict::ShapeMatters);
}

TEST(RegimeLaw, OnALayerTheShapeMattersMore)
{
  const auto tool = Paraboloid{}.make();
  MaterialRange range(LayerBase::Bonded);
  const ContactSpot spot{ 0.06, 0.45, 0.0, 2.0 };
  range.add(spot);
  const RegimeLaw law(*tool, range, Deepest);
  const SpotRegime found = law.regime(spot, 1.0, law.force(spot, 1.0));
  EXPECT_LT(found.index, 0.0); // the base makes the layer stiffer than a half-space
  EXPECT_GT(found.sensitivity, 0.5);
}

TEST(RegimeLaw, AWholeBodyHalfOfWhichGivesWay)
{
  constexpr std::size_t count = 20000; // enough for several threads
  const Paraboloid paraboloid;
  const auto tool = paraboloid.make();
  BodyMaterial::Values values;
  values.compliance.name = "C";
  for (std::size_t i = 0; i < count; ++i)
  {
    values.compliance.values.push_back(i % 2 == 0 ? 0.0 : 400.0);
  }
  BodyMaterial material({ 0.06, 0.0, 0.0, LayerBase::Bonded, false });
  ASSERT_EQ(material.take(std::move(values), count), "");
  std::vector<float> index(count);
  std::vector<float> sensitivity(count);
  std::vector<std::uint8_t> verdict(count);
  ASSERT_EQ(regime(*tool, material, std::vector<double>(count, 1.0), 1.0, nullptr,
              { index.data(), sensitivity.data(), verdict.data() }),
    "");
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto wanted =
      i % 2 == 0 ? RegimeVerdict::ShapeMatters : RegimeVerdict::PointForceSuffices;
    ASSERT_EQ(verdict[i], static_cast<std::uint8_t>(wanted)) << i;
    ASSERT_EQ(index[i] > 0.5F, i % 2 != 0) << i;
    ASSERT_EQ(sensitivity[i] > 0.4F, i % 2 == 0) << i;
  }
}

TEST(RegimeLaw, AResponseOfAnotherMaterialIsNamed)
{
  constexpr int samples = 8;
  const Paraboloid paraboloid;
  const auto tool = paraboloid.make();
  BodyMaterial material({ 0.06, 0.0, 0.0, LayerBase::Bonded, false });
  ASSERT_EQ(material.take({}, 2), "");
  std::vector<float> force;
  std::vector<float> stiffness;
  for (const double modulus : { 0.06, 0.0615 }) // differ by 2.5 %
  {
    for (int i = 1; i <= samples; ++i)
    {
      const double depth = Deepest * i * i / (samples * samples);
      force.push_back(static_cast<float>(paraboloid.force(depth, modulus)));
      stiffness.push_back(static_cast<float>(1.5 * paraboloid.force(depth, modulus) / depth));
    }
  }
  const std::array<float, 6> normal = { 0, 0, 1, 0, 0, 1 };
  const std::array<float, 2> range = { Deepest, Deepest };
  const std::array<std::uint8_t, 2> status = { 0, 0 };
  ComparedResponse given{ {}, "Soft" };
  ResponseArrays& stored = given.arrays;
  stored.points = 2;
  stored.samples = samples;
  stored.exponent = 1.5;
  stored.force = force.data();
  stored.stiffness = stiffness.data();
  stored.normal = normal.data();
  stored.range = range.data();
  stored.status = status.data();
  std::array<float, 2> index{};
  std::array<float, 2> sensitivity{};
  std::array<std::uint8_t, 2> verdict{};
  const RegimeSpans spans{ index.data(), sensitivity.data(), verdict.data() };
  EXPECT_EQ(regime(*tool, material, { 1.0, 1.0 }, 1.0, &given, spans)
              .find("Response 'Soft' is of another material: point 1 at 1"),
    0U);
  // Depths below a hundredth of the range are not compared.
  EXPECT_EQ(regime(*tool, material, { 1.0, 0.01 }, 1.0, &given, spans), "");
}
} // namespace regime_law
