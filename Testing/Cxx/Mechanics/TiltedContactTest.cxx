// SPDX-License-Identifier: BSD-3-Clause
// A tilted tool on a half-space by boundary elements, and the law of the flat end.
#include "Mechanics/Tilt/TiltBody.h"
#include "Mechanics/Tilt/TiltGeometry.h"
#include "Mechanics/Tilt/TiltedContact.h"
#include "Mechanics/Tilt/TiltedFlat.h"
#include "Mechanics/Tilt/TiltedTool.h"

#include "Agreement.h"
#include "ReferenceTable.h"
#include "TestTools.h"
#include "TiltReference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace palpate::testing
{
TEST(TiltedContact, AgreesWithClosedFormsUpright)
{
  // 64 pixels over a smooth contact, whose edge becomes a staircase, have an error of 1.5e-4 of the
  // force, the square of pixel / contact diameter. The work has twice this error, as an energy
  // bound. At a sharp rim the error is a part of pixel / radius, 6e-3.
  struct Case
  {
    const char* tool;
    double tolerance;
  };
  for (const Case& each :
    { Case{ "cone:60", 1.5e-4 }, { "sphere:2", 1.5e-4 }, { "paraboloid:1", 1.5e-4 },
      { "blunted:1,45", 1.5e-4 }, { "truncated:1,45", 3e-4 }, { "flat:1", 6e-3 } })
  {
    const auto shape = tool(each.tool);
    const TiltedForce solved = solveTilted(*shape, 0.0, 0.7);
    EXPECT_TRUE(agrees(solved.perModulus, shape->force(0.7, 1.0), each.tolerance)) << each.tool;
    EXPECT_TRUE(agrees(solved.work, pressedInto(*shape, {}, 0.7).work, 2.0 * each.tolerance))
      << each.tool;
  }
}

TEST(TiltedContact, ASphereFeelsNoTilt)
{
  const auto sphere = tool("sphere:2");
  const double closed = sphere->force(0.5, 1.0);
  EXPECT_TRUE(agrees(solveTilted(*sphere, 40.0 * Degree, 0.5).perModulus, closed, 1e-4));
  EXPECT_TRUE(agrees(solveTilted(*sphere, 40.0 * Degree, 0.5, 128).perModulus, closed, 3e-5));
}

TEST(TiltedContact, AgreesWithAnotherSolver)
{
  // Compares every 19th row. Errors of both grids together: 1e-4 for smooth contacts, 2e-3 at
  // edges, 1.8 % at flat rims with small contacts.
  const ReferenceTable table("tilt/tilt_bem.csv");
  int rows = 0;
  for (std::size_t row = 0; row < table.size(); row += 19)
  {
    const std::string& name = table.text(row, "tool");
    const double depth = table.number(row, "D");
    const bool isFlat = name == "flat";
    const double tolerance = isFlat ? (depth < 0.05 ? 0.018 : 6e-3)
      : name.rfind("trunc", 0) == 0 ? 4e-3
                                    : 5e-4;
    const auto shape = tool(tiltedToolOf(name));
    const double angle = table.number(row, "theta_deg") * Degree;
    const TiltedForce solved = solveTilted(*shape, angle, depth);
    EXPECT_TRUE(agrees(solved.perModulus, table.number(row, "F_over_Estar"), tolerance))
      << name << ' ' << angle << ' ' << depth;
    ++rows;
  }
  EXPECT_GE(rows, 20);
}

TEST(TiltedContact, AFlatEndHasOneLaw)
{
  const ReferenceTable table("tilt/flat_tilt_universal.csv");
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double q = table.number(row, "q=D/(a theta)");
    const double f = tiltedFlatForce(q).value;
    // Error of the table: 0.2 % from q = 0.5 on, 1 % at 0.01.
    EXPECT_TRUE(agrees(f, table.number(row, "f=F/(2a^2 E* theta)"), q < 0.1 ? 3e-3 : 2e-3)) << q;
    const double m = 1.5 * (q * q * tiltedFlatWork(3.0 / q).value - q * f + f);
    EXPECT_TRUE(agrees(m, table.number(row, "m=M/((4/3)E* a^3 theta)"), q < 0.1 ? 3e-3 : 2.5e-3))
      << q;
  }
  // Full contact: F = 2 a E* δ and M = 4/3 E* a³ θ, the integrals of Boussinesq's pressure.
  EXPECT_DOUBLE_EQ(tiltedFlatForce(4.0).value, 3.0);
  EXPECT_NEAR(1.5 * (16.0 * tiltedFlatWork(0.75).value - 12.0 + 3.0), 1.0, 1e-14);
}

TEST(TiltedContact, TheFlatEndsLawIsSmooth)
{
  for (const double s : { 0.3, 0.99, 1.01, 2.0, 7.0, 50.0 })
  {
    constexpr double step = 1e-5;
    const TiltedFlatTerm before = tiltedFlatWork(s - step);
    const TiltedFlatTerm after = tiltedFlatWork(s + step);
    const TiltedFlatTerm at = tiltedFlatWork(s);
    // Error of central differences: step², plus rounding / step.
    EXPECT_NEAR((after.value - before.value) / (2.0 * step), at.slope, 1e-8) << s;
    EXPECT_NEAR((after.slope - before.slope) / (2.0 * step), at.bend, 1e-8) << s;
    const double q = 3.0 / s;
    const TiltedFlatTerm force = tiltedFlatForce(q);
    EXPECT_NEAR((tiltedFlatForce(q + step).value - tiltedFlatForce(q - step).value) / (2.0 * step),
      force.slope, 1e-8);
    EXPECT_NEAR((tiltedFlatForce(q + step).slope - tiltedFlatForce(q - step).slope) / (2.0 * step),
      force.bend, 1e-6);
  }
  // Value, slope and bend are continuous at the onset of full contact, up to the rounding of a
  // polynomial with terms of the size 100.
  const TiltedFlatTerm rim = tiltedFlatForce(std::nextafter(3.0, 0.0));
  EXPECT_NEAR(rim.value, 2.0, 1e-11);
  EXPECT_NEAR(rim.slope, 1.0, 1e-11);
  EXPECT_NEAR(rim.bend, 0.0, 1e-10);
}

TEST(TiltedContact, TheDeepestPointIsWhereTheProfileSays)
{
  for (const char* text : { "sphere:3", "flat:2", "cone:60", "truncated:1,50", "blunted:1,50",
         "rounded:1,0.5", "paraboloid:2", "power:3,0.2", "profile:0,0;1,0.1;2,0.5;3,2" })
  {
    const auto shape = tool(text);
    for (const double angle : { 5.0 * Degree, 20.0 * Degree, 30.0 * Degree })
    {
      if (!checkTilt(*shape, angle).empty())
      {
        continue;
      }
      // by a search on a grid of 1e-4 mm; at a corner the error is up to 0.2 times this
      double deepest = 0.0;
      for (int i = 0; i <= 40000; ++i)
      {
        const double r = std::min(4.0, shape->largestContactRadius()) * i / 40000;
        const double f = shape->profile(r);
        deepest = std::max(deepest, r * std::sin(angle) - f * std::cos(angle));
      }
      const DeepestPoint point = deepestPoint(*shape, angle);
      EXPECT_NEAR(point.drop, deepest, 2e-5) << text << ' ' << angle;
      const double step = 1e-6; // the offset is dh/dθ
      EXPECT_NEAR(
        (deepestPoint(*shape, angle + step).drop - deepestPoint(*shape, angle - step).drop) /
          (2.0 * step),
        point.offset, 1e-5)
        << text << ' ' << angle;
    }
  }
}

TEST(TiltedContact, AFlankEndsTheTilts)
{
  EXPECT_NEAR(largestTilt(*tool("cone:60")), 26.0 * Degree, 1e-9);
  // Far from the tip the slope of a truncated or blunted cone is that of its flank, to 1e-6.
  EXPECT_NEAR(largestTilt(*tool("truncated:1,50")), 36.0 * Degree, 1e-5);
  EXPECT_NEAR(largestTilt(*tool("blunted:1,50")), 36.0 * Degree, 1e-5);
  EXPECT_NEAR(largestTilt(*tool("profile:0,0;1,0.1;2,1.1")), 41.0 * Degree, 1e-9);
  EXPECT_NEAR(largestTilt(*tool("sphere:1")), 80.0 * Degree, 1e-9);
  EXPECT_NEAR(largestTilt(*tool("flat:1")), 80.0 * Degree, 1e-9);
  EXPECT_EQ(checkTilt(*tool("cone:60"), 26.0 * Degree), "");
  const std::string fault = checkTilt(*tool("cone:60"), 27.0 * Degree);
  EXPECT_NE(fault.find("27 degrees"), std::string::npos) << fault;
  EXPECT_NE(fault.find("26 degrees"), std::string::npos) << fault;
  EXPECT_NE(checkTilt(*tool("cone:87"), 1.0 * Degree), "");
  EXPECT_NE(checkTilt(*tool("sphere:1"), 0.0), "");
}

TEST(TiltedContact, AToolMadeFromItsContactRadiiIsThatTool)
{
  // The paraboloid a² = RD from samples of a(D). The other results follow from g by closed forms.
  std::vector<TiltedTool::Sample> samples;
  for (const double depth : { 0.01, 0.1, 0.5, 1.0 })
  {
    samples.push_back({ depth, std::sqrt(2.0 * depth), 0.5 });
  }
  const TiltedTool made("made", samples, false);
  const auto paraboloid = tool("paraboloid:2");
  for (const double depth : { 1e-3, 0.05, 0.3, 1.0, 4.0 })
  {
    EXPECT_TRUE(agrees(made.force(depth, 1.0), paraboloid->force(depth, 1.0), 1e-12));
    EXPECT_TRUE(agrees(made.contactRadius(depth), paraboloid->contactRadius(depth), 1e-12));
    const double a = paraboloid->contactRadius(depth);
    EXPECT_TRUE(agrees(made.reducedProfile(a), depth, 1e-12));
    EXPECT_TRUE(agrees(made.profile(a), paraboloid->profile(a), 1e-9)); // 64 Gauss points
    EXPECT_TRUE(
      agrees(made.pressure(0.5 * a, depth, 1.0), paraboloid->pressure(0.5 * a, depth, 1.0), 1e-9));
  }
  EXPECT_NEAR(made.forceExponent(), 1.5, 1e-15);
  EXPECT_TRUE(agrees(made.depthAtStrain(0.3), paraboloid->depthAtStrain(0.3), 1e-9));
}
} // namespace palpate::testing
