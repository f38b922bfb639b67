// SPDX-License-Identifier: BSD-3-Clause
// Sampled tools have the law of the shape from which they are sampled, with an error of second
// order.
#include "Mechanics/Tools/ProfileTool.h"

#include "Agreement.h"
#include "ScratchFile.h"
#include "TestTools.h"
#include "Mechanics/Numerics/Constants.h"

#include <fstream>

using palpate::Infinity;
using palpate::ProfilePoint;
using palpate::ProfileTool;
using palpate::testing::agrees;
using palpate::testing::tool;

namespace
{
std::vector<ProfilePoint> sampled(
  const palpate::AxisymmetricTool& shape, double outer, int segments)
{
  std::vector<ProfilePoint> points;
  for (int i = 0; i <= segments; ++i)
  {
    const double r = outer * i / segments;
    points.push_back({ r, shape.profile(r) });
  }
  return points;
}

double errorOf(const palpate::AxisymmetricTool& shape, int segments, double outer, double depth)
{
  const ProfileTool profile(sampled(shape, outer, segments));
  return std::abs(profile.force(depth, 1.0) / shape.force(depth, 1.0) - 1.0);
}
} // namespace

TEST(ProfileTool, ErrorFallsWithTheSquareOfTheSpacing)
{
  struct Case
  {
    const char* name;
    double outer;
    double depth;
  };
  for (const Case& each : { Case{ "paraboloid:6.35", 4.0, 1.0 }, Case{ "sphere:6.35", 4.0, 1.0 },
         Case{ "power:4,0.01", 4.0, 1.0 }, Case{ "rounded:1.2,0.4", 2.4, 1.0 } })
  {
    const auto shape = tool(each.name);
    double previous = errorOf(*shape, 32, each.outer, each.depth);
    for (const int segments : { 64, 128, 256, 512 })
    {
      const double error = errorOf(*shape, segments, each.outer, each.depth);
      // Twice the segments give a quarter of the error. Terms of higher order, and a contact that
      // ends within a segment, change this factor of 4: 3.6 to 4.5 were observed.
      EXPECT_GT(previous / error, 3.2) << each.name << " " << segments;
      EXPECT_LT(previous / error, 5.0) << each.name << " " << segments;
      previous = error;
    }
  }
  // The reference sheet states 1.5e-5 for 128 segments. Here the profile ends at 4 mm and the
  // contact at 2.5 mm.
  EXPECT_LT(errorOf(*tool("paraboloid:6.35"), 128, 4.0, 1.0), 3e-5);
}

TEST(ProfileTool, StraightShapesAreExact)
{
  for (const char* name : { "cone:60", "truncated:1,60", "flat:1.6" })
  {
    const auto shape = tool(name);
    const bool flat = std::isfinite(shape->largestContactRadius());
    // 4 segments put a point at r = 1
    const ProfileTool profile(sampled(*shape, flat ? 1.6 : 4.0, 4));
    for (const double depth : { 1e-6, 0.1, 0.7 })
    {
      EXPECT_TRUE(agrees(profile.contactRadius(depth), shape->contactRadius(depth), 1e-14));
      EXPECT_TRUE(agrees(profile.force(depth, 1.0), shape->force(depth, 1.0), 1e-14));
      for (const double share : { 1e-3, 0.5, 0.95, 1.1, 3.0 })
      {
        const double r = share * shape->contactRadius(depth);
        EXPECT_TRUE(agrees(profile.pressure(r, depth, 1.0), shape->pressure(r, depth, 1.0), 1e-10))
          << name << " " << depth << " " << share;
        const auto u = shape->surfaceDisplacement(r, depth, 0.2);
        const auto v = profile.surfaceDisplacement(r, depth, 0.2);
        EXPECT_TRUE(agrees(v.normal, u.normal, 1e-10)) << name << " " << depth << " " << share;
        EXPECT_TRUE(agrees(v.radial, u.radial, 1e-10)) << name << " " << depth << " " << share;
      }
    }
  }
}

TEST(ProfileTool, ExponentOfTheShapeSampled)
{
  EXPECT_NEAR(ProfileTool(sampled(*tool("paraboloid:5"), 3.0, 100)).forceExponent(), 1.5, 1e-3);
  EXPECT_NEAR(ProfileTool(sampled(*tool("cone:60"), 3.0, 7)).forceExponent(), 2.0, 1e-12);
  EXPECT_EQ(ProfileTool({ { 0.0, 0.0 }, { 1.6, 0.0 } }).forceExponent(), 1.0);
}

TEST(ProfileTool, RadiiItReports)
{
  const auto t =
    // the corner at r = 3 counts; (2, 1) lies on a straight line
    tool("profile:0,0;1,0;2,1;3,2;4,4");
  EXPECT_EQ(t->kinks(), (std::vector<double>{ 1.0, 3.0 }));
  EXPECT_EQ(t->smallestContactRadius(), 1.0);
  EXPECT_EQ(t->largestContactRadius(), 4.0);
  const auto punch = tool("profile:0,0;1.6,0");
  EXPECT_EQ(punch->kinks(), (std::vector<double>{ 1.6 }));
  EXPECT_EQ(punch->smallestContactRadius(), 1.6);
  EXPECT_EQ(tool("profile:0,0;1,1;2,3")->smallestContactRadius(), 0.0);
}

TEST(ProfileTool, BeyondItsWallAFlatPunch)
{
  const auto t = tool("profile:0,0;1,0.25;2,1");
  const double whole = t->depthAtContactRadius(2.0);
  const double force = t->force(whole, 1.0);
  for (const double more : { 1e-6, 0.1, 3.0, 1e6 })
  {
    EXPECT_EQ(t->contactRadius(whole + more), 2.0);
    // (whole + more) - whole is rounded.
    EXPECT_TRUE(agrees(t->force(whole + more, 1.0), force + 4.0 * more, 1e-14));
  }
  EXPECT_EQ(t->depthAtContactRadius(2.0000001), Infinity);
}

TEST(ProfileTool, WrongPointsAreNamed)
{
  const auto fault = [](const std::vector<ProfilePoint>& points)
  { return ProfileTool::check(points); };
  const auto names = [](const std::string& text, const char* part)
  { EXPECT_NE(text.find(part), std::string::npos) << part << " is not in: " << text; };
  names(fault({}), "two points or more, but has 0");
  names(fault({ { 0.0, 0.0 } }), "but has 1");
  names(fault({ { 0.5, 0.0 }, { 1.0, 1.0 } }), "point 0 (r = 0.5, f = 0) must be the tip");
  names(fault({ { 0.0, 0.1 }, { 1.0, 1.0 } }), "point 0 (r = 0, f = 0.1) must be the tip");
  names(fault({ { 0.0, 0.0 }, { 1.0, 1.0 }, { 1.0, 2.0 } }), "point 2 (r = 1, f = 2)");
  names(fault({ { 0.0, 0.0 }, { 2.0, 1.0 }, { 1.0, 2.0 } }), "at r = 2");
  names(fault({ { 0.0, 0.0 }, { 1.0, NAN } }), "point 1 (r = 1, f = nan) must be finite");
  names(fault({ { 0.0, 0.0 }, { Infinity, 1.0 } }), "must be finite");
  // A ring below the tip: no depth is valid, and the message states this.
  names(fault({ { 0.0, 0.0 }, { 0.5, -0.0625 }, { 1.0, 0.5 } }), "r = 0.5");
  names(fault({ { 0.0, 0.0 }, { 0.5, -0.0625 }, { 1.0, 0.5 } }), "no δ > 0");
  EXPECT_EQ(fault({ { 0.0, 0.0 }, { 1.0, 0.0 } }), "");
}

class ProfileFileTest : public ::testing::Test
{
protected:
  std::string write(const std::string& content)
  {
    std::ofstream(this->File.path()) << content;
    return this->File.path();
  }
  std::string errorOf(const std::string& content)
  {
    palpate::ToolSpecification kept;
    kept.Profile = { { 0.0, 0.0 }, { 7.0, 1.0 } };
    std::string error;
    EXPECT_FALSE(palpate::parseTool("profile:" + this->write(content), kept, error));
    EXPECT_EQ(kept.Profile.size(), 2U);
    EXPECT_EQ(kept.Shape, palpate::ToolShape::Sphere);
    return error;
  }
  void expectNamed(const std::string& content, const std::string& part)
  {
    const std::string error = this->errorOf(content);
    EXPECT_NE(error.find(part), std::string::npos) << part << " is not in: " << error;
  }

  palpate::testing::ScratchFile File{ ".csv" };
};

TEST_F(ProfileFileTest, ReadsHeaderCommentsAndBlankLines)
{
  const std::string file =
    this->write("# a turned tip\n\nr_mm, f_mm\r\n0, 0\n 1 ,\t0.25\n# half way\n2,1e0\r\n\n");
  palpate::ToolSpecification read;
  std::string error;
  ASSERT_TRUE(palpate::parseTool("profile:" + file, read, error)) << error;
  ASSERT_EQ(read.Profile.size(), 3U);
  EXPECT_EQ(read.Profile[1].r, 1.0);
  EXPECT_EQ(read.Profile[1].f, 0.25);
  EXPECT_EQ(read.Profile[2].f, 1.0);
  // Semicolons may also separate columns.
  ASSERT_TRUE(palpate::parseTool("profile:" + this->write("0;0\n1;0.25\n2;1\n"), read, error))
    << error;
  // The specification lists the points and does not refer to the file.
  EXPECT_EQ(palpate::makeTool(read)->specification(), "profile:0,0;1,0.25;2,1");
}

TEST_F(ProfileFileTest, WhatIsWrongIsNamedWithItsLine)
{
  this->expectNamed("r,f\n0,0\n1,x\n2,1\n", this->File.path() + ":3: column 2: 'x'");
  this->expectNamed("0,0\n1\n", ":2: '1'");
  this->expectNamed("0,0\n1,2,3\n", ":2: '1' is not a profile point");
  this->expectNamed("0,0\nr,f\n1,1\n", ":2: column 1: 'r'");
  this->expectNamed("r,f\nr,f\n0,0\n1,1\n", ":2: column 1: 'r'");
  this->expectNamed("0|0\n1|1\n", ":1: '0|0'");
  this->expectNamed("# c\n0,0\n2,1\n1,2\n", ":4: ");
  this->expectNamed("0.1,0\n1,1\n", ":1: ");
  this->expectNamed("0,0\n1,-0.5\n", ":2: ");
  this->expectNamed("0,0\n", "two points or more, but has 1");
  this->expectNamed("", "but has 0");
  palpate::ToolSpecification kept;
  std::string error;
  EXPECT_FALSE(palpate::parseTool("profile:/nowhere/tip.csv", kept, error));
  EXPECT_NE(error.find("/nowhere/tip.csv: cannot be opened"), std::string::npos) << error;
  // the path is a folder
  EXPECT_FALSE(palpate::parseTool("profile:" + ::testing::TempDir(), kept, error));
}

TEST(ProfileSpecification, RoundTripToTheBit)
{
  std::vector<ProfilePoint> points = { { 0.0, 0.0 } };
  for (int i = 1; i <= 50; ++i)
  {
    points.push_back({ points.back().r + std::exp(0.7 * std::sin(i)), std::pow(1.1, i) / 3.0 });
  }
  const ProfileTool given(points);
  palpate::ToolSpecification read;
  std::string error;
  ASSERT_TRUE(palpate::parseTool(given.specification(), read, error)) << error;
  ASSERT_EQ(read.Profile.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_EQ(read.Profile[i].r, points[i].r);
    EXPECT_EQ(read.Profile[i].f, points[i].f);
  }
  for (const char* wrong : { "profile:0,0;", "profile:;0,0;1,1", "profile:0,0;1",
         "profile:0,0;1,1,1", "profile:0,0;1,1mm", "profile:", "profile:0,0" })
  {
    EXPECT_FALSE(palpate::parseTool(wrong, read, error)) << wrong;
    EXPECT_EQ(read.Profile.size(), points.size());
  }
}
