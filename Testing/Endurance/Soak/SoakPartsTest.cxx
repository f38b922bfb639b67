// SPDX-License-Identifier: BSD-3-Clause
// Tests of the parts of the soak: closed forms, depths, swaps and memory.
#include "MemoryWatch.h"
#include "SwapWatch.h"
#include "RoundBody.h"
#include "ToolLaw.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace palpate::endurance
{
TEST(ToolLaw, GivesKnownForces)
{
  // The rubber of the paper: at this depth the curves of the 12.7 mm sphere (as a paraboloid) and
  // of the 3.2 mm flat punch intersect.
  const double depth = 0.9070866142;
  const double force = 10.0142362205;
  EXPECT_NEAR(ToolLaw(ToolLaw::Flat, 1.6).force(depth, 3.45), force, 1e-8);
  EXPECT_NEAR(ToolLaw(ToolLaw::Paraboloid, 6.35).force(depth, 3.45), force, 1e-8);
  // The exact 3.2 mm sphere needs 1.7505 mm for 12 N. The source gives no more digits.
  EXPECT_NEAR(ToolLaw(ToolLaw::Sphere, 1.6).force(1.7505, 3.45), 12.0, 1e-3);
  EXPECT_NEAR(ToolLaw(ToolLaw::Cone, 45.0).force(1.0, 1.0), 2.0 / 3.14159265358979, 1e-12);
}

TEST(ToolLaw, StiffnessIsTheSlopeAndTheCapItsIntegral)
{
  for (const ToolLaw& law : { ToolLaw(ToolLaw::Flat, 3.0), ToolLaw(ToolLaw::Paraboloid, 6.0),
         ToolLaw(ToolLaw::Cone, 70.0), ToolLaw(ToolLaw::Sphere, 12.0) })
  {
    constexpr int steps = 20000;
    constexpr double end = 4.0;
    constexpr double width = end / steps;
    const double most = law.stiffness(0.4 * end, 0.2);
    double whole = 0.0;
    double capped = 0.0;
    for (int i = 0; i < steps; ++i)
    {
      const double slope = law.stiffness((i + 0.5) * width, 0.2);
      whole += width * slope;
      capped += width * std::fmin(slope, most);
    }
    // The error of the midpoint rule on √δ is 0.08 width^1.5 times the factor before the root.
    EXPECT_NEAR(law.force(end, 0.2), whole, 1e-6) << law.name();
    EXPECT_NEAR(law.cappedForce(end, 0.2, most), capped, 1e-6) << law.name();
    EXPECT_EQ(law.cappedForce(0.1 * end, 0.2, most), law.force(0.1 * end, 0.2)) << law.name();
  }
}

TEST(RoundBody, TellsTheDepthInASphere)
{
  BodyForm form;
  form.centre = Vector3(1.0, 2.0, 3.0);
  const RoundBody body(form, 3);
  for (int i = 0; i < 500; ++i)
  {
    const Vector3 u = Vector3(std::sin(i), std::cos(2.0 * i), std::sin(3.0 * i + 1.0)).normalized();
    for (const double depth : { -2.0, 1.0, 3.0 })
    {
      const auto touches = body.touch(form.centre + (50.0 - depth) * u);
      ASSERT_FALSE(touches.empty());
      // Facets of 8 mm are up to h²/(6 R) = 0.22 mm below the sphere. Their corners are on the
      // sphere.
      EXPECT_LE(touches.front().depth, depth + 1e-9);
      EXPECT_GE(touches.front().depth, depth - 0.25);
      // The interpolated normal turns by less than the shift of the contact point along a tilted
      // facet.
      EXPECT_GT(touches.front().normal.dot(u), std::cos(0.02));
      EXPECT_DOUBLE_EQ(touches.front().modulus, form.modulus);
    }
  }
}

TEST(RoundBody, FindsTheNearestPointOfAllTriangles)
{
  BodyForm form;
  form.bumps = 0.5;
  form.halfAxes = Vector3(49.0, 51.0, 50.5);
  const RoundBody body(form, 2);
  // Compares with a grid of points on every triangle: no grid point is nearer, and one is nearly as
  // near.
  constexpr int cuts = 24;
  for (int i = 0; i < 20; ++i)
  {
    const Vector3 u = Vector3(std::cos(i), std::sin(2.0 * i), std::cos(3.0 * i)).normalized();
    const Vector3 tip = (i % 2 == 0 ? 48.0 : 52.0) * u;
    double least = 1e9;
    for (const auto& t : body.triangles())
    {
      for (int a = 0; a <= cuts; ++a)
      {
        for (int b = 0; a + b <= cuts; ++b)
        {
          const Vector3 point = (a * body.points()[static_cast<std::size_t>(t[0])] +
                                  b * body.points()[static_cast<std::size_t>(t[1])] +
                                  (cuts - a - b) * body.points()[static_cast<std::size_t>(t[2])]) /
            cuts;
          least = std::min(least, (tip - point).norm());
        }
      }
    }
    const double found = std::abs(body.touch(tip).front().depth);
    EXPECT_LE(found, least + 1e-12);
    // Grid points are 16 mm / 24 apart. Perpendicular to the nearest point this gives 0.4²/(2·1) at
    // a depth of 1 mm.
    EXPECT_GE(found, least - 0.1);
  }
}

TEST(SwapWatch, CountsWhatComesLateOrNever)
{
  SwapWatch swaps;
  std::uint64_t tick = 0;
  const auto go = [&](std::uint32_t scene, int ticks)
  {
    for (int i = 0; i < ticks; ++i)
    {
      swaps.see(tick++, scene);
    }
  };
  go(0, 10);
  swaps.ask(10); // tick 10 may still use the old scene, tick 11 must not
  go(0, 1);
  go(1, 5);
  EXPECT_EQ(swaps.seen(), 1U);
  EXPECT_EQ(swaps.late(), 0U);
  swaps.ask(tick);
  go(2, 5); // immediately
  EXPECT_EQ(swaps.seen(), 2U);
  EXPECT_EQ(swaps.late(), 0U);
  swaps.ask(tick);
  go(2, 2); // one tick too late
  go(3, 5);
  EXPECT_EQ(swaps.seen(), 3U);
  EXPECT_EQ(swaps.late(), 1U);
  swaps.ask(tick);
  go(3, 100); // never
  EXPECT_EQ(swaps.asked(), 4U);
  EXPECT_EQ(swaps.seen(), 3U);
  EXPECT_EQ(swaps.late(), 2U);
}

TEST(MemoryWatch, FindsWhatGrows)
{
  MemoryWatch steady(60);
  MemoryWatch growing(60);
  for (int i = 0; i < 60; ++i)
  {
    const std::vector<char> used(std::size_t{ 1 } << 20U, 'x');
    steady.read();
  }
  std::vector<std::unique_ptr<std::vector<char>>> kept;
  for (int i = 0; i < 60; ++i)
  {
    kept.push_back(std::make_unique<std::vector<char>>(std::size_t{ 1 } << 18U, 'x'));
    growing.read();
  }
  EXPECT_LE(steady.heap().growth(), MemoryWatch::HeapAllowed);
  EXPECT_LE(steady.resident().growth(), MemoryWatch::ResidentAllowed);
  // From reading 29 to reading 59, each reading grows by a quarter of a MiB.
  EXPECT_GT(growing.heap().growth(), 7.0);
  EXPECT_GT(growing.resident().growth(), MemoryWatch::ResidentAllowed);
}
} // namespace palpate::endurance
