// SPDX-License-Identifier: BSD-3-Clause
// The events that end the force, the times at which they do so, and the restart afterwards.
#include "Haptics/Safety/SafetyChain.h"

#include "ChainedWall.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace safety_loss
{
using Eigen::Vector3d;
using namespace palpate;
using palpate::Infinity;
using palpate::NotANumber;
using namespace palpate::testing;

TEST(SafetyLoss, EveryLossIsZeroInTheSameTickAndClosesTheGate)
{
  struct Loss
  {
    SafetyLink link;
    std::function<void(SafetyInput&, SafetyChain&)> spoil;
  };
  const Loss losses[] = {
    { SafetyLink::NotFinite,
      [](SafetyInput& in, SafetyChain&) { in.idealForce.y() = NotANumber; } },
    { SafetyLink::NotFinite, [](SafetyInput& in, SafetyChain&) { in.cappedForce.z() = Infinity; } },
    { SafetyLink::NotFinite, [](SafetyInput& in, SafetyChain&) { in.time = NotANumber; } },
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
    EXPECT_EQ(lost.force, Vector3d::Zero()); // exactly zero, although the slew limit is 5 N per
                                             // tick
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
    // After the tip has been outside, the force is as before. At the large depth, the slew limit
    // starts at zero.
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
  bad.idealForce.x() = NotANumber;
  EXPECT_EQ(wall.Chain.apply(bad).force, Vector3d::Zero());
  EXPECT_EQ(wall.feel(8e-3).force, Vector3d::Zero()); // no time has passed since the restart
  EXPECT_NEAR(wall.feel(8e-3).force.z(), 5.0, 1e-9);
}

// A missing reading, or a reading without a valid position, suppresses the force only in its own
// ticks and in those of the slew limit.
TEST(SafetyLoss, AGapEndsTheForceAndNotTheTouch)
{
  const std::function<void(SafetyInput&)> gaps[] = { [](SafetyInput& in) { in.valid = false; },
    [](SafetyInput& in) { in.position.x() = NotANumber; },
    [](SafetyInput& in) { in.position.y() = -Infinity; } };
  for (const auto& spoil : gaps)
  {
    for (const int ticks : { 1, 5, 18 })
    {
      ChainedWall wall(whole());
      wall.press();
      const double energy = wall.Chain.energy();
      for (int i = 0; i < ticks; ++i)
      {
        SafetyInput bad = wall.at(4e-3);
        spoil(bad);
        const SafeForce none = wall.Chain.apply(bad);
        EXPECT_EQ(none.force, Vector3d::Zero());
        EXPECT_EQ(none.acted, flag(SafetyLink::NoSample));
        EXPECT_TRUE(none.isGap);
      }
      EXPECT_EQ(wall.Chain.energy(), energy);
      const SafeForce back = wall.feel(4e-3);
      EXPECT_NEAR(back.force.z(), 4.0, 1e-12) << ticks;
      EXPECT_EQ(back.acted, 0);
      // The tip is deeper after the gap. The force starts at zero, with 5 N per tick.
      SafetyInput bad = wall.at(4e-3);
      spoil(bad);
      wall.Chain.apply(bad);
      const SafeForce deeper = wall.feel(5.5e-3);
      EXPECT_NEAR(deeper.force.z(), 5.0, 1e-9);
      EXPECT_TRUE(deeper.has(SafetyLink::Slew));
    }
  }
}

TEST(SafetyLoss, AGapThatIsLongerThanTheTimeOutIsALoss)
{
  for (const double timeOut : { 0.01, 0.02, Infinity })
  {
    SafetySettings settings = whole();
    settings.sampleTimeOut = timeOut;
    ChainedWall wall(settings);
    wall.press();
    SafeForce safe;
    int gap = 0;
    do
    {
      SafetyInput bad = wall.at(4e-3);
      bad.valid = false;
      safe = wall.Chain.apply(bad);
      EXPECT_EQ(safe.force, Vector3d::Zero());
      ++gap;
    } while (safe.isGap && gap < 1000);
    // A device without its own time-out has the default of 20 ms. There is one tick more if the sum
    // of the ticks is rounded.
    EXPECT_NEAR(gap, timeOut == 0.01 ? 11 : 21, 1);
    EXPECT_EQ(wall.Chain.energy(), 0.0);
    safe = wall.feel(4e-3);
    EXPECT_EQ(safe.force, Vector3d::Zero());
    EXPECT_EQ(wall.feel(4e-3).acted, flag(SafetyLink::Gate));
    EXPECT_EQ(wall.feel(0.0).acted, 0);
  }
}

TEST(SafetyLoss, AForceIsToldForATime)
{
  ChainedWall wall(whole());
  EXPECT_EQ(wall.feel(0.0).holdTime, 0.02) << "none: as long as may be";
  const SafeForce deep = wall.press();
  EXPECT_GT(deep.holdTime, SafetyChain::LeastHold * Period);
  EXPECT_LT(deep.holdTime, 0.02);
  wall.feel(0.0);
  EXPECT_EQ(wall.feel(1e-4).holdTime, SafetyChain::LeastHold * Period)
    << "hardly anything is put in";
  SafetySettings free = whole();
  free.controlPassivity = false;
  EXPECT_EQ(ChainedWall(free).press().holdTime, 0.02);
}

// Without passivity control, a hand that moves deeper during a gap could get more energy than it
// put in. The gate prevents this.
TEST(SafetyLoss, WithoutPassivityControlThereAreNoGaps)
{
  SafetySettings settings = whole();
  settings.controlPassivity = false;
  ChainedWall wall(settings);
  wall.press();
  SafetyInput bad = wall.at(4e-3);
  bad.valid = false;
  EXPECT_FALSE(wall.Chain.apply(bad).isGap);
  EXPECT_EQ(wall.feel(4e-3).acted, flag(SafetyLink::Gate));
}

// A hand that knows when readings are missing moves inward while there is no force and outward
// while there is a force. It gains no energy, for gaps of one to nine ticks. It accelerates by at
// most 20 m/s².
TEST(SafetyLoss, NoMotionGetsEnergyOutOfGaps)
{
  for (const bool gate : { true, false })
  {
    for (unsigned seed = 1; seed <= 20; ++seed)
    {
      std::mt19937 random(seed);
      const auto below = [&random](unsigned n) { return static_cast<int>(random() % n); };
      SafetySettings settings = whole();
      settings.gate = gate;
      settings.maximumForceRate = Infinity;
      ChainedWall wall(settings);
      wall.press();
      double depth = 4e-3;
      double speed = 0.0; // m/s, inward
      double given = 0.0; // work of the force on the hand since the contact began, less the energy
                          // dissipated
      const double put = wall.Chain.energy();
      Vector3d force(0.0, 0.0, 4.0);
      const auto go = [&](double wanted, bool isMissing)
      {
        const double change = PassivityControl::HandAcceleration * Period;
        speed = std::clamp(wanted, speed - change, speed + change);
        const double to = std::clamp(depth + speed * Period, 5e-4, 7e-3);
        const double moved = depth - to; // outward, along the force
        given += force.z() * moved - 0.5 * settings.maximumStiffness * moved * moved;
        depth = to;
        SafetyInput input = wall.at(depth);
        input.valid = !isMissing;
        force = wall.Chain.apply(input).force;
      };
      for (int cycle = 0; cycle < 200; ++cycle)
      {
        const int ticks = 1 + below(9);
        for (int i = 0; i < ticks; ++i)
        {
          go(0.2, true);
        }
        for (int i = 0; i < 12; ++i)
        {
          go(-0.1, below(20) == 0);
        }
        ASSERT_LE(given, put + 1e-9) << seed << " " << cycle;
      }
    }
  }
}

TEST(SafetyLoss, SilenceEndsTheForceAfterTheTimeOutInTicks)
{
  // The device repeats its sample. 20 ms are allowed, so the 21st tick without a new sample has no
  // force.
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
    // One tick more if the rounded sum of the ticks is 20 ms or less.
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
  EXPECT_EQ(wall.feel(1e-3).acted, flag(SafetyLink::Gate)); // outside while stopped does not open
                                                            // the gate
  wall.press();
  wall.Chain.reset();
  wall.Time = 0.0; // a new session with its own clock
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
    double allowed = 0.0; // energy dissipated by the damping, and energy allowed on purpose
    int forces = 0;
    SafeForce safe;
    Vector3d last = Vector3d::Zero();
    Vector3d place = Vector3d::Zero();
    for (int i = 0; i < 5000; ++i)
    {
      SafetyInput input;
      time += Period;
      input.time = often(0.002) ? NotANumber : often(0.002) ? time - 0.5 : time;
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
        input.cappedForce.x() = often(0.5) ? NotANumber : 1e300;
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
} // namespace safety_loss
