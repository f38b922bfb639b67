// SPDX-License-Identifier: BSD-3-Clause
// The depth beyond which a profile touches the body outside its circle of contact, compared with
// the gap computed by the tests' own quadrature of the exact reduced profile.
#include "Mechanics/Tools/DepthLimit.h"

#include "Agreement.h"
#include "GeneralTool.h"
#include "Quadrature.h"
#include "TestTools.h"

using palpate::Pi;
using palpate::testing::agrees;
using palpate::testing::Quadrature;
using palpate::testing::tool;

namespace
{
// A cone of 45° with a shoulder: f = min(r, 1) up to r = 20.
const char* const Shoulder = "profile:0,0;1,1;20,1";

/// Penetration of the shoulder, δ - f - u_z at r > 1, while the contact is on the cone: a = 2δ/π.
double penetration(double depth, double r)
{
  const double a = 2.0 * depth / Pi;
  const double x = a / r;
  const double outside = 2.0 / Pi * depth *
    (std::asin(x) + (std::sqrt(1.0 - x * x) - 1.0) / x); // u_z of the cone with c = 1
  return depth - 1.0 - outside;
}

/// The depth at which the gap between the body and a shoulder with the given slope closes at r. By
/// bisection, to a thousandth of δ.
double closingDepth(double r, double slope)
{
  double low = 0.5;
  double high = 1.5;
  for (int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (low + high);
    (penetration(middle, r) - slope * (r - 1.0) > 1e-3 * middle ? high : low) = middle;
  }
  return low;
}
} // namespace

TEST(DepthLimit, OfAConeWithAShoulder)
{
  const auto t = tool(Shoulder);
  // Values of the reference sheet: at δ = 1.1, a = 0.70 and the shoulder penetrates by 0.088 at r =
  // 20.
  EXPECT_NEAR(2.0 * 1.1 / Pi, 0.70, 0.005);
  EXPECT_NEAR(penetration(1.1, 20.0), 0.088, 0.0005);
  EXPECT_TRUE(std::isnan(t->force(1.1, 1.0)));

  // The gap closes first at the outer end of the shoulder.
  const palpate::DepthLimit limit = t->depthLimit();
  EXPECT_EQ(limit.radius, 20.0);
  // 1e-3: the library samples g at 500 points
  EXPECT_TRUE(agrees(limit.depth, closingDepth(20.0, 0.0), 1e-3));
}

TEST(DepthLimit, OfAShoulderHoweverWide)
{
  // A shoulder with a very small slope. Behind the corner, g falls over a length of 1 mm or more, a
  // tiny part of a wide shoulder. The gap closes first where the sum of rise and u_z is smallest.
  struct Case
  {
    const char* tool;
    double radius;
    double slope;
  };
  for (const Case& each : { Case{ "profile:0,0;1,1;100,1.99", 100.0, 0.01 },
         Case{ "profile:0,0;1,1;1000001,11", 1000001.0, 1e-5 },
         Case{ "profile:0,0;1,1;1000000000001,11", 1e12 + 1.0, 1e-11 },
         Case{ "profile:0,0;1,1;1e18,10", 1e18, 9e-18 } })
  {
    double closing = 2.0;
    for (double r = 1.01; r < each.radius; r *= 1.01)
    {
      closing = std::min(closing, closingDepth(r, each.slope));
    }
    // 1e-3: the library samples g at 500 points.
    EXPECT_TRUE(agrees(tool(each.tool)->depthLimit().depth, closing, 1e-3)) << each.tool;
  }
}

TEST(DepthLimit, EveryAnswerBeyondItIsNaN)
{
  const auto t = tool(Shoulder);
  const double limit = t->depthLimit().depth;
  EXPECT_TRUE(std::isnan(t->force(1.001 * limit, 1.0)));
  EXPECT_TRUE(std::isnan(t->stiffness(1.001 * limit, 1.0)));
  EXPECT_TRUE(std::isnan(t->contactRadius(1.001 * limit)));
  EXPECT_TRUE(std::isnan(t->pressure(0.1, 1.001 * limit, 1.0)));
  EXPECT_TRUE(std::isnan(t->surfaceDisplacement(0.1, 1.001 * limit, 0.3).normal));
  EXPECT_TRUE(std::isnan(t->surfaceDisplacement(50.0, 1.001 * limit, 0.3).radial));
  const std::string text = t->checkDepth(1.1);
  EXPECT_NE(text.find("1.1 mm"), std::string::npos) << text;
  EXPECT_NE(text.find("r = 20 mm"), std::string::npos) << text;
  // Up to this depth the force is that of the cone.
  EXPECT_EQ(t->checkDepth(0.999 * limit), "");
  EXPECT_TRUE(
    agrees(t->force(0.999 * limit, 1.0), tool("cone:45")->force(0.999 * limit, 1.0), 1e-14));
}

TEST(DepthLimit, IsTheRootOfTheGapOfAnyProfile)
{
  // A cone with waves that are too deep to be filled at once. At the returned depth the computed
  // surface must touch the tool, within the tolerance of a thousandth, and at no smaller depth may
  // it touch outside the contact.
  const auto t = tool("profile:0,0;1,0.6;1.5,0.5;2,1;3,1.8;4,1.7;5,2.6");
  const palpate::DepthLimit limit = t->depthLimit();
  ASSERT_TRUE(std::isfinite(limit.depth));
  const auto largest = [&](double depth)
  {
    double worst = -1.0;
    for (int i = 1; i <= 2000; ++i)
    {
      const double r = 5.0 * i / 2000;
      if (r > t->contactRadius(depth))
      {
        const double over = depth - t->profile(r) - t->surfaceDisplacement(r, depth, 0.3).normal;
        worst = std::max(worst, over / depth);
      }
    }
    return worst;
  };
  // The depth has an error of 1e-3 in either direction, and the gap closes at a rate below 1.
  EXPECT_NEAR(largest(limit.depth), 1e-3, 1e-3);
  EXPECT_LT(largest(0.99 * limit.depth), 0.0);
}

TEST(DepthLimit, ARingAsLowAsTheTipAllowsNothing)
{
  const auto t = tool("profile:0,0;0.5,0.5;1,0;2,2");
  EXPECT_LT(t->depthLimit().depth, 1e-6);
  EXPECT_NEAR(t->depthLimit().radius, 1.0, 0.01);
  EXPECT_TRUE(std::isnan(t->force(0.01, 1.0)));
}

TEST(DepthLimit, ConvexProfilesHaveNone)
{
  for (const char* name : { "flat:1", "sphere:2", "paraboloid:2", "cone:60", "truncated:1,60",
         "blunted:1,60", "rounded:1,0.5", "power:1.5,1", "profile:0,0;1,0.2;2,1", "profile:0,0;1,0",
         "profile:0,0;1,0;2,1;3,3" })
  {
    EXPECT_TRUE(std::isinf(tool(name)->depthLimit().depth)) << name;
    EXPECT_EQ(tool(name)->checkDepth(1e9), "") << name;
  }
}

TEST(DepthLimit, SamplesOfASmoothConcaveProfileAreOneTool)
{
  // f = sin r + 0.1 r is concave everywhere, but g rises up to r = 1.2 and beyond. Each sampled
  // point is a concave corner; the law must not end at any of them.
  palpate::GeneralTool::Shape shape{ [](double r) { return std::sin(r) + 0.1 * r; },
    [](double r) { return std::cos(r) + 0.1; }, [](double r) { return -std::sin(r); }, {}, 0.0,
    1.2 };
  const palpate::GeneralTool smooth(shape);
  EXPECT_TRUE(std::isinf(smooth.depthLimit().depth));
  std::vector<palpate::ProfilePoint> points;
  for (int i = 0; i <= 100; ++i)
  {
    points.push_back({ 0.012 * i, shape.profile(0.012 * i) });
  }
  const palpate::ProfileTool sampled(points);
  EXPECT_TRUE(std::isinf(sampled.depthLimit().depth));
  for (const double depth : { 0.1, 0.5, 1.0, 3.0 })
  {
    // The error is of second order: (r/100)² times a factor.
    EXPECT_TRUE(agrees(sampled.force(depth, 1.0), smooth.force(depth, 1.0), 1e-4)) << depth;
    EXPECT_TRUE(agrees(sampled.contactRadius(depth), smooth.contactRadius(depth), 1e-2)) << depth;
  }
}

TEST(DepthLimit, CostsAtMostTwoThousandthsOfTheForce)
{
  // The force decreases if the profile is raised. With the dips of g filled (its running maximum)
  // the profile is higher and in full contact, so the force is a lower bound. The tolerance changes
  // the force by less than the difference from this bound.
  const auto t = tool("profile:0,0;1,0.3;2,0.59;3,0.87;4,1.6");
  ASSERT_TRUE(std::isinf(t->depthLimit().depth));
  const Quadrature rule(4000);
  for (const double depth : { 0.6, 1.0, 1.4 })
  {
    const double filled = 2.0 *
      rule.integrate(
        0.0, t->contactRadius(depth), [&](double x) { return depth - t->depthAtContactRadius(x); });
    EXPECT_NEAR(filled / t->force(depth, 1.0), 1.0, 2e-3) << depth;
    EXPECT_LT(filled, t->force(depth, 1.0)) << depth;
  }
}
