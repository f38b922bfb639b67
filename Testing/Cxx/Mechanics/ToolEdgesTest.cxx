// SPDX-License-Identifier: BSD-3-Clause
// Results of the tools at and beyond the limits of their arguments.
#include "Agreement.h"
#include "Quadrature.h"
#include "TestTools.h"
#include "Mechanics/Numerics/Constants.h"

#include <string>

using palpate::Pi;
using palpate::testing::agrees;
using palpate::testing::tool;

using palpate::Infinity;
using palpate::NotANumber;

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
  EXPECT_TRUE(std::isnan(t.force(NotANumber, 3.0)));
  EXPECT_TRUE(std::isnan(t.force(1.0, NotANumber)));
  EXPECT_TRUE(std::isnan(t.stiffness(NotANumber, 3.0)));
  EXPECT_TRUE(std::isnan(t.stiffness(1.0, NotANumber)));
  EXPECT_TRUE(std::isnan(t.contactRadius(NotANumber)));
  EXPECT_TRUE(std::isnan(t.pressure(0.1, NotANumber, 3.0)));
  EXPECT_TRUE(std::isnan(t.pressure(NotANumber, 1.0, 3.0)));
  EXPECT_TRUE(std::isnan(t.surfaceDisplacement(0.1, NotANumber, 0.3).normal));
  EXPECT_TRUE(std::isnan(t.surfaceDisplacement(0.1, NotANumber, 0.3).radial));
  EXPECT_TRUE(std::isnan(t.surfaceDisplacement(NotANumber, 1.0, 0.3).normal));
  EXPECT_TRUE(std::isnan(t.surfaceDisplacement(0.1, 1.0, NotANumber).radial));
  EXPECT_TRUE(std::isnan(t.profile(NotANumber)));
  EXPECT_TRUE(std::isnan(t.depthAtStrain(NotANumber)));
  EXPECT_TRUE(std::isnan(t.depthAtContactRadius(NotANumber)));
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
  // F(δ)/F(δ/4) = 4^m. At these depths the exact sphere is a paraboloid to δ/10R = 1e-13.
  // forceExponent of a profile describes its middle; its first segment is a cone or a flat end.
  const std::string name = this->GetParam();
  const bool profile = name.substr(0, 7) == "profile";
  const double exponent = !profile              ? this->Tool->forceExponent()
    : this->Tool->smallestContactRadius() > 0.0 ? 1.0
                                                : 2.0;
  const double power = std::pow(4.0, exponent);
  // The fillet of a rounded flat end widens the contact by (3δR_e/b²)^(2/3)/2 = 6e-9 at 1e-12 mm
  // and raises the force by a fifth of this.
  const double widening = name.substr(0, 7) == "rounded" ? 2e-9 : 0.0;
  for (const double depth : { 1e-12, 1e-60, 1e-120 })
  {
    EXPECT_TRUE(agrees(this->Tool->force(depth, 1.0), power * this->Tool->force(0.25 * depth, 1.0),
      1e-12 + (depth == 1e-12 ? widening : 0.0)))
      << depth;
  }
}

INSTANTIATE_TEST_SUITE_P(Tools, ToolEdges,
  ::testing::Values("flat:1.6", "paraboloid:6.35", "sphere:1.6", "cone:60", "truncated:1,60",
    "blunted:1,60", "rounded:1.2,0.4", "power:1,0.5", "power:1.5,0.1", "power:4,0.01",
    "profile:0,0;3,1.2", "profile:0,0;1,0;3,1.2", "profile:0,0;1.6,0"));

TEST(ToolSingularities, InfinitePressure)
{
  EXPECT_EQ(tool("flat:1.6")->pressure(1.6, 0.5, 3.0), Infinity);
  EXPECT_EQ(tool("cone:60")->pressure(0.0, 0.5, 3.0), Infinity);
  const auto paraboloid = tool("paraboloid:6.35");
  EXPECT_EQ(paraboloid->pressure(paraboloid->contactRadius(0.5), 0.5, 3.0), 0.0);
  const auto cone = tool("cone:60");
  EXPECT_EQ(cone->pressure(cone->contactRadius(0.5), 0.5, 3.0), 0.0);
  EXPECT_EQ(tool("truncated:1,60")->pressure(1.0, 0.5, 3.0), Infinity);
  EXPECT_EQ(tool("power:1,0.5")->pressure(0.0, 0.5, 3.0), Infinity);
  // A profile with an apex, a convex edge, a concave edge and the wall.
  const auto profile = tool("profile:0,0;1,0.5;2,2;3,3.45");
  EXPECT_EQ(profile->pressure(0.0, 6.0, 3.0), Infinity);
  EXPECT_EQ(profile->pressure(1.0, 6.0, 3.0), Infinity);
  EXPECT_EQ(profile->pressure(2.0, 6.0, 3.0), -Infinity);
  EXPECT_EQ(profile->pressure(3.0, 6.0, 3.0), Infinity);
}

TEST(ToolSingularities, WallsOfTheProfile)
{
  EXPECT_EQ(tool("flat:1.6")->profile(1.6), 0.0);
  EXPECT_EQ(tool("flat:1.6")->profile(1.6000001), Infinity);
  EXPECT_TRUE(agrees(tool("sphere:1.6")->profile(1.6), 1.6, 1e-15)); // computed as R·R/R
  EXPECT_EQ(tool("sphere:1.6")->profile(1.6000001), Infinity);
  // R - √(R²-r²) = r²/2R at the tip, to (r/R)²/4.
  EXPECT_TRUE(agrees(tool("sphere:1.6")->profile(1e-9), 1e-18 / 3.2, 1e-15));
  EXPECT_TRUE(agrees(tool("cone:45")->profile(7.0), 7.0, 1e-15));
  EXPECT_EQ(tool("profile:0,0;1,0.5;2,2")->profile(1.5), 1.25);
  EXPECT_EQ(tool("profile:0,0;1,0.5;2,2")->profile(2.0), 2.0);
  EXPECT_EQ(tool("profile:0,0;1,0.5;2,2")->profile(2.0000001), Infinity);
}

TEST(ToolDepths, AtStrain)
{
  // Flat end: δ/a. Paraboloid: a/R = √(δ/R). Sphere: δ = a artanh(a/R).
  EXPECT_TRUE(agrees(tool("flat:1.6")->depthAtStrain(0.4), 0.64, 1e-15));
  EXPECT_TRUE(agrees(tool("paraboloid:2")->depthAtStrain(0.4), 0.32, 1e-15));
  EXPECT_TRUE(agrees(tool("sphere:2")->depthAtStrain(0.4), 0.8 * std::atanh(0.4), 1e-15));
  // A cone has the same strain at every depth, δ/a = π/2 cot α. Smaller strains are reached at
  // depth 0, larger ones never.
  EXPECT_EQ(tool("cone:60")->depthAtStrain(0.4), 0.0);
  EXPECT_EQ(tool("cone:80")->depthAtStrain(0.4), Infinity);
  EXPECT_EQ(tool("sphere:2")->depthAtStrain(1.0), Infinity);
}

TEST(ToolDepths, AtStrainOfTheOtherShapes)
{
  // The strain by its definition: a/R of the tip, or δ/a.
  for (const char* name : { "blunted:2,60", "truncated:1,80", "rounded:1.2,0.4", "power:1.5,0.1",
         "power:4,0.01", "profile:0,0;1,0.1;2,0.5;3,3", "profile:0,0;1,0;2,0.5" })
  {
    const auto t = tool(name);
    const double depth = t->depthAtStrain(0.25);
    const double a = t->contactRadius(depth);
    const bool tip = std::string(name).substr(0, 7) == "blunted";
    EXPECT_TRUE(agrees(tip ? a / 2.0 : depth / a, 0.25, 1e-12)) << name;
  }
  EXPECT_EQ(tool("power:1,0.5")->depthAtStrain(0.4), 0.0); // δ/a = π/4 at every depth
  EXPECT_EQ(tool("power:1,0.1")->depthAtStrain(0.4), Infinity);
  // The whole cone has δ/a = (π/2) cot 80° = 0.277, which is an upper bound.
  EXPECT_EQ(tool("truncated:1,80")->depthAtStrain(0.4), Infinity);
  EXPECT_EQ(tool("profile:0,0;1,0.5;2,2")->depthAtStrain(0.4), 0.0);
  // Beyond its last point a profile acts as a flat punch, with the strain δ/a.
  EXPECT_TRUE(agrees(tool("profile:0,0;2,0.1")->depthAtStrain(0.4), 0.8, 1e-15));
}

TEST(ToolDepths, AtContactRadius)
{
  EXPECT_EQ(tool("flat:1.6")->depthAtContactRadius(1.6), 0.0);
  EXPECT_EQ(tool("flat:1.6")->depthAtContactRadius(1.7), Infinity);
  EXPECT_TRUE(agrees(tool("paraboloid:2")->depthAtContactRadius(0.5), 0.125, 1e-15));
  EXPECT_TRUE(agrees(tool("cone:45")->depthAtContactRadius(0.5), 0.25 * Pi, 1e-15));
  EXPECT_EQ(tool("sphere:1.6")->depthAtContactRadius(1.6), Infinity);
  EXPECT_EQ(tool("sphere:1.6")->depthAtContactRadius(2.0), Infinity);
  EXPECT_EQ(tool("truncated:1,60")->depthAtContactRadius(1.0), 0.0);
  EXPECT_EQ(tool("rounded:1.2,0.4")->depthAtContactRadius(0.5), 0.0);
  EXPECT_EQ(tool("profile:0,0;1,0;2,2")->depthAtContactRadius(0.5), 0.0);
  EXPECT_EQ(tool("profile:0,0;1,0;2,2")->depthAtContactRadius(2.1), Infinity);
  for (const char* name :
    { "paraboloid:6.35", "sphere:1.6", "cone:60", "blunted:1,60", "power:1.5,0.1", "power:4,0.01",
      "truncated:1,60", "rounded:1.2,0.4", "profile:0,0;1,0.1;2,0.6;4,4" })
  {
    const auto t = tool(name);
    for (const double depth : { 1e-6, 0.1, 1.0 })
    {
      // Near a flat end the rounding of `a` changes g by 1e-16 (b/(a-b)), which is visible at
      // depths of 1e-6 mm.
      const double tolerance = t->smallestContactRadius() > 0.0 && depth < 0.1 ? 1e-3 : 2e-14;
      EXPECT_TRUE(agrees(t->depthAtContactRadius(t->contactRadius(depth)), depth, tolerance))
        << name;
    }
  }
}
