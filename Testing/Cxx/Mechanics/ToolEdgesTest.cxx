// SPDX-License-Identifier: BSD-3-Clause
// What the tools answer at and beyond the edges of their arguments.
#include "Agreement.h"
#include "Quadrature.h"
#include "TestTools.h"

#include <limits>
#include <string>

using palpate::testing::agrees;
using palpate::testing::Pi;
using palpate::testing::tool;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();
} // namespace

class ToolEdges : public ::testing::TestWithParam<const char*>
{
protected:
  std::unique_ptr<palpate::AxisymmetricTool> Tool = tool(this->GetParam());
};

TEST_P(ToolEdges, NoContactIsZero)
{
  for (const double depth : { 0.0, -0.0, -1.0, -Infinity })
  {
    EXPECT_EQ(this->Tool->force(depth, 3.0), 0.0);
    EXPECT_EQ(this->Tool->stiffness(depth, 3.0), 0.0);
    EXPECT_EQ(this->Tool->contactRadius(depth), 0.0);
    for (const double r : { 0.0, 0.5, 100.0 })
    {
      EXPECT_EQ(this->Tool->pressure(r, depth, 3.0), 0.0);
      EXPECT_EQ(this->Tool->surfaceDisplacement(r, depth, 0.3).normal, 0.0);
      EXPECT_EQ(this->Tool->surfaceDisplacement(r, depth, 0.3).radial, 0.0);
    }
  }
}

TEST_P(ToolEdges, NaNGivesNaN)
{
  const auto& t = *this->Tool;
  EXPECT_TRUE(std::isnan(t.force(NaN, 3.0)));
  EXPECT_TRUE(std::isnan(t.force(1.0, NaN)));
  EXPECT_TRUE(std::isnan(t.stiffness(NaN, 3.0)));
  EXPECT_TRUE(std::isnan(t.stiffness(1.0, NaN)));
  EXPECT_TRUE(std::isnan(t.contactRadius(NaN)));
  EXPECT_TRUE(std::isnan(t.pressure(0.1, NaN, 3.0)));
  EXPECT_TRUE(std::isnan(t.pressure(NaN, 1.0, 3.0)));
  EXPECT_TRUE(std::isnan(t.surfaceDisplacement(0.1, NaN, 0.3).normal));
  EXPECT_TRUE(std::isnan(t.surfaceDisplacement(0.1, NaN, 0.3).radial));
  EXPECT_TRUE(std::isnan(t.surfaceDisplacement(NaN, 1.0, 0.3).normal));
  EXPECT_TRUE(std::isnan(t.surfaceDisplacement(0.1, 1.0, NaN).radial));
  EXPECT_TRUE(std::isnan(t.profile(NaN)));
  EXPECT_TRUE(std::isnan(t.depthAtStrain(NaN)));
  EXPECT_TRUE(std::isnan(t.depthAtContactRadius(NaN)));
}

TEST_P(ToolEdges, NegativeDistanceIsNaN)
{
  EXPECT_TRUE(std::isnan(this->Tool->pressure(-1e-9, 1.0, 3.0)));
  EXPECT_TRUE(std::isnan(this->Tool->surfaceDisplacement(-1e-9, 1.0, 0.3).normal));
  EXPECT_TRUE(std::isnan(this->Tool->surfaceDisplacement(-1e-9, 1.0, 0.3).radial));
}

TEST_P(ToolEdges, NoPressureOutside)
{
  const double a = this->Tool->contactRadius(0.5);
  EXPECT_EQ(this->Tool->pressure(std::nextafter(a, Infinity), 0.5, 3.0), 0.0);
  EXPECT_EQ(this->Tool->pressure(1e300, 0.5, 3.0), 0.0);
  EXPECT_EQ(this->Tool->pressure(Infinity, 0.5, 3.0), 0.0);
  EXPECT_GT(this->Tool->pressure(0.999 * a, 0.5, 3.0), 0.0);
}

TEST_P(ToolEdges, NothingMovesInfinitelyFarAway)
{
  const auto u = this->Tool->surfaceDisplacement(Infinity, 0.5, 0.3);
  EXPECT_EQ(u.normal, 0.0);
  EXPECT_EQ(u.radial, 0.0);
}

TEST_P(ToolEdges, OnTheAxis)
{
  const auto u = this->Tool->surfaceDisplacement(0.0, 0.5, 0.3);
  EXPECT_EQ(u.normal, 0.5);
  EXPECT_EQ(u.radial, 0.0);
  EXPECT_EQ(this->Tool->profile(0.0), 0.0);
}

TEST_P(ToolEdges, TinyDepthsKeepTheirPower)
{
  // F(δ)/F(δ/4) = 4^m; the exact sphere is a paraboloid there to δ/10R = 1e-13.
  const double power = std::pow(4.0, this->Tool->forceExponent());
  for (const double depth : { 1e-12, 1e-60, 1e-120 })
  {
    EXPECT_TRUE(
      agrees(this->Tool->force(depth, 1.0), power * this->Tool->force(0.25 * depth, 1.0), 1e-12))
      << depth;
  }
}

INSTANTIATE_TEST_SUITE_P(
  Tools, ToolEdges, ::testing::Values("flat:1.6", "paraboloid:6.35", "sphere:1.6", "cone:60"));

TEST(ToolSingularities, InfinitePressure)
{
  EXPECT_EQ(tool("flat:1.6")->pressure(1.6, 0.5, 3.0), Infinity);
  EXPECT_EQ(tool("cone:60")->pressure(0.0, 0.5, 3.0), Infinity);
  const auto paraboloid = tool("paraboloid:6.35");
  EXPECT_EQ(paraboloid->pressure(paraboloid->contactRadius(0.5), 0.5, 3.0), 0.0);
  const auto cone = tool("cone:60");
  EXPECT_EQ(cone->pressure(cone->contactRadius(0.5), 0.5, 3.0), 0.0);
}

TEST(ToolSingularities, WallsOfTheProfile)
{
  EXPECT_EQ(tool("flat:1.6")->profile(1.6), 0.0);
  EXPECT_EQ(tool("flat:1.6")->profile(1.6000001), Infinity);
  EXPECT_TRUE(agrees(tool("sphere:1.6")->profile(1.6), 1.6, 1e-15)); // R·R/R
  EXPECT_EQ(tool("sphere:1.6")->profile(1.6000001), Infinity);
  // R - √(R²-r²) = r²/2R at the tip, to (r/R)²/4.
  EXPECT_TRUE(agrees(tool("sphere:1.6")->profile(1e-9), 1e-18 / 3.2, 1e-15));
  EXPECT_TRUE(agrees(tool("cone:45")->profile(7.0), 7.0, 1e-15));
}

TEST(ToolDepths, AtStrain)
{
  // Flat: δ/a. Paraboloid: a/R = √(δ/R). Sphere: δ = a artanh(a/R). One product each.
  EXPECT_TRUE(agrees(tool("flat:1.6")->depthAtStrain(0.4), 0.64, 1e-15));
  EXPECT_TRUE(agrees(tool("paraboloid:2")->depthAtStrain(0.4), 0.32, 1e-15));
  EXPECT_TRUE(agrees(tool("sphere:2")->depthAtStrain(0.4), 0.8 * std::atanh(0.4), 1e-15));
  // A cone's is the same at every depth, δ/a = π/2 cot α: at once or never.
  EXPECT_EQ(tool("cone:60")->depthAtStrain(0.4), 0.0);
  EXPECT_EQ(tool("cone:80")->depthAtStrain(0.4), Infinity);
  EXPECT_EQ(tool("sphere:2")->depthAtStrain(1.0), Infinity);
}

TEST(ToolDepths, AtContactRadius)
{
  EXPECT_EQ(tool("flat:1.6")->depthAtContactRadius(1.6), 0.0);
  EXPECT_EQ(tool("flat:1.6")->depthAtContactRadius(1.7), Infinity);
  EXPECT_TRUE(agrees(tool("paraboloid:2")->depthAtContactRadius(0.5), 0.125, 1e-15));
  EXPECT_TRUE(agrees(tool("cone:45")->depthAtContactRadius(0.5), 0.25 * Pi, 1e-15));
  EXPECT_EQ(tool("sphere:1.6")->depthAtContactRadius(1.6), Infinity);
  EXPECT_EQ(tool("sphere:1.6")->depthAtContactRadius(2.0), Infinity);
  for (const char* name : { "paraboloid:6.35", "sphere:1.6", "cone:60" })
  {
    const auto t = tool(name);
    for (const double depth : { 1e-6, 0.1, 1.0 })
    {
      EXPECT_TRUE(agrees(t->depthAtContactRadius(t->contactRadius(depth)), depth, 1e-14)) << name;
    }
  }
}
