// SPDX-License-Identifier: BSD-3-Clause
// What ends the force, when, and what begins anew after that.
#include "Haptics/Safety/SafetyChain.h"

#include "ChainedWall.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

using Eigen::Vector3d;
using namespace palpate;
using namespace palpate::testing;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();
} // namespace

TEST(SafetyLoss, EveryLossIsZeroInTheSameTickAndClosesTheGate)
{
  struct Loss
  {
    SafetyLink link;
    std::function<void(SafetyInput&, SafetyChain&)> spoil;
  };
  const Loss losses[] = {
    { SafetyLink::NoSample, [](SafetyInput& in, SafetyChain&) { in.valid = false; } },
    { SafetyLink::NoSample, [](SafetyInput& in, SafetyChain&) { in.position.x() = NaN; } },
    { SafetyLink::NoSample, [](SafetyInput& in, SafetyChain&) { in.position.y() = -Infinity; } },
    { SafetyLink::NotFinite, [](SafetyInput& in, SafetyChain&) { in.idealForce.y() = NaN; } },
    { SafetyLink::NotFinite, [](SafetyInput& in, SafetyChain&) { in.cappedForce.z() = Infinity; } },
    { SafetyLink::NotFinite, [](SafetyInput& in, SafetyChain&) { in.time = NaN; } },
    { SafetyLink::NotFinite, [](SafetyInput& in, SafetyChain&) { in.time = Infinity; } },
    { SafetyLink::Watchdog, [](SafetyInput& in, SafetyChain&) { in.time -= 1.5 * Period; } },
    { SafetyLink::Watchdog, [](SafetyInput& in, SafetyChain&) { in.time += 0.021; } },
    { SafetyLink::Stopped, [](SafetyInput&, SafetyChain& chain) { chain.stop(); } },
  };
  for (const Loss& loss : losses)
  {
    SCOPED_TRACE(&loss - losses);
    ChainedWall wall(whole());
    EXPECT_NEAR(wall.press().force.z(), 4.0, 1e-12);
    EXPECT_GT(wall.Chain.energy(), 3e-3);
    SafetyInput bad = wall.at(4e-3);
    loss.spoil(bad, wall.Chain);
    const SafeForce lost = wall.Chain.apply(bad);
    EXPECT_EQ(lost.force, Vector3d::Zero()); // exactly, though the slew limit is 5 N per tick
    EXPECT_TRUE(lost.has(loss.link));
    EXPECT_EQ(wall.Chain.energy(), 0.0);
    wall.Chain.start();
    wall.Time = std::isfinite(bad.time) ? bad.time + Period : wall.Time;
    for (int i = 0; i < 5; ++i)
    {
      const SafeForce inside = wall.feel(4e-3);
      EXPECT_EQ(inside.force, Vector3d::Zero());
      EXPECT_EQ(inside.acted, flag(SafetyLink::Gate));
    }
    // Once outside all is as before; thrown in deep, the slew limit begins at nothing.
    EXPECT_EQ(wall.feel(0.0).acted, 0);
    const SafeForce again = wall.feel(8e-3);
    EXPECT_NEAR(again.force.z(), 5.0, 1e-9);
    EXPECT_TRUE(again.has(SafetyLink::Slew));
  }
}

TEST(SafetyLoss, WithoutAGateTheForceComesBackFromNothing)
{
  SafetySettings settings = whole();
  settings.gate = false;
  ChainedWall wall(settings);
  wall.press();
  SafetyInput bad = wall.at(4e-3);
  bad.valid = false;
  EXPECT_EQ(wall.Chain.apply(bad).force, Vector3d::Zero());
  EXPECT_EQ(wall.feel(8e-3).force, Vector3d::Zero()); // no time since it began anew
  EXPECT_NEAR(wall.feel(8e-3).force.z(), 5.0, 1e-9);
}

TEST(SafetyLoss, SilenceEndsTheForceAfterTheTimeOutInTicks)
{
  // The device repeats itself: 20 ms are allowed, so the 21st tick without news is without force.
  for (const double start : { 0.0, 10.0, 12345.0 })
  {
    ChainedWall wall(whole());
    wall.Time = start;
    wall.press();
    int silent = 0;
    SafeForce safe;
    do
    {
      SafetyInput input = wall.at(4e-3);
      input.fresh = false;
      safe = wall.Chain.apply(input);
      ++silent;
      EXPECT_EQ(safe.has(SafetyLink::Watchdog), safe.force.isZero(0.0));
    } while (!safe.force.isZero(0.0) && silent < 100);
    // One more where the sum of the ticks rounds to 20 ms and less.
    EXPECT_GE(silent, 20);
    EXPECT_LE(silent, 22);
    for (int i = 0; i < 100; ++i)
    {
      SafetyInput input = wall.at(4e-3);
      input.fresh = false;
      EXPECT_EQ(wall.Chain.apply(input).force, Vector3d::Zero());
    }
  }
}

TEST(SafetyLoss, StopStartReset)
{
  ChainedWall wall(whole());
  wall.press();
  wall.Chain.stop();
  EXPECT_TRUE(wall.Chain.isStopped());
  wall.Chain.reset();
  EXPECT_EQ(wall.feel(0.0).acted, flag(SafetyLink::Stopped));
  EXPECT_EQ(wall.feel(1e-3).force, Vector3d::Zero());
  wall.Chain.start();
  EXPECT_EQ(wall.feel(1e-3).acted, flag(SafetyLink::Gate)); // outside while stopped does not count
  wall.press();
  wall.Chain.reset();
  wall.Time = 0.0; // a session of its own, by its own clock
  EXPECT_EQ(wall.feel(4e-3).acted, flag(SafetyLink::Gate));
  EXPECT_NEAR(wall.press().force.z(), 4.0, 1e-12);
}

TEST(SafetyLoss, WhateverComesInWhatGoesOutIsSafe)
{
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    std::mt19937 random(seed);
    std::normal_distribution<double> gauss;
    std::uniform_real_distribution<double> share(0.0, 1.0);
    const auto often = [&](double probability) { return share(random) < probability; };
    SafetySettings settings = whole();
    settings.maximumForce = 6.0;
    settings.gate = seed % 2 == 0;
    settings.entryRamp = seed % 5 == 0 ? 0.05 : 0.0;
    SafetyChain chain(settings);
    double time = 0.0;
    double given = 0.0;
    double allowed = 0.0; // what the damping takes, and what is given on purpose
    int forces = 0;
    SafeForce safe;
    Vector3d last = Vector3d::Zero();
    Vector3d place = Vector3d::Zero();
    for (int i = 0; i < 5000; ++i)
    {
      SafetyInput input;
      time += Period;
      input.time = often(0.002) ? NaN : often(0.002) ? time - 0.5 : time;
      input.valid = !often(0.003);
      input.fresh = !often(0.1);
      place = input.fresh
        ? Vector3d(0.95 * place + 3e-4 * Vector3d::NullaryExpr([&] { return gauss(random); }))
        : place;
      input.position = place;
      input.outside = often(0.05);
      input.idealForce = input.outside
        ? Vector3d::Zero()
        : Vector3d(4.0 * Vector3d::NullaryExpr([&] { return gauss(random); }));
      input.cappedForce = share(random) * input.idealForce;
      if (often(0.003))
      {
        input.cappedForce.x() = often(0.5) ? NaN : 1e300;
      }
      const Vector3d moved = place - last;
      given += safe.force.dot(moved);
      allowed += settings.maximumStiffness * moved.squaredNorm(); // LargestCredit is 2
      const bool wasNew = chain.energy() == 0.0;
      safe = chain.apply(input);
      allowed += wasNew ? 0.5 * safe.force.squaredNorm() / settings.maximumStiffness : 0.0;
      last = place;
      ASSERT_TRUE(safe.force.allFinite());
      ASSERT_LE(safe.force.norm(), 6.0 * (1.0 + 1e-15));
      const std::uint16_t losses = flag(SafetyLink::NotFinite) + flag(SafetyLink::Watchdog) +
        flag(SafetyLink::NoSample) + flag(SafetyLink::Stopped);
      if ((safe.acted & losses) != 0 || !input.valid || !std::isfinite(input.time))
      {
        ASSERT_EQ(safe.force, Vector3d::Zero());
      }
      forces += safe.force.norm() > 0.01;
    }
    EXPECT_GT(forces, 300) << seed;
    EXPECT_LT(given, allowed) << seed;
  }
}
