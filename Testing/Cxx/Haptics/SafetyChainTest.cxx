// SPDX-License-Identifier: BSD-3-Clause
// All links together: their order, and the effect of each on the force.
#include "Haptics/Safety/SafetyChain.h"

#include "ChainedWall.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace safety_chain
{
using Eigen::Vector3d;
using namespace palpate;
using palpate::Infinity;
using palpate::NotANumber;
using namespace palpate::testing;

TEST(SafetyChain, PassesWhatNeedsNothing)
{
  ChainedWall wall(whole());
  for (int i = -10; i <= 40; ++i)
  {
    const SafetyInput input = wall.at(1e-4 * i);
    const SafeForce safe = wall.Chain.apply(input);
    EXPECT_EQ(safe.force, input.idealForce);
    EXPECT_EQ(safe.forceFactor, 1.0);
    EXPECT_EQ(safe.acted, 0);
  }
}

TEST(SafetyChain, GateIsClosedUntilOnceOutside)
{
  ChainedWall wall(whole());
  for (int i = 0; i < 50; ++i)
  {
    const SafeForce safe = wall.feel(3e-3);
    EXPECT_EQ(safe.force, Vector3d::Zero());
    EXPECT_EQ(safe.acted, flag(SafetyLink::Gate));
  }
  EXPECT_EQ(wall.feel(0.0).acted, 0);
  EXPECT_GT(wall.feel(1e-4).force.z(), 0.09);
}

TEST(SafetyChain, FixedOrder)
{
  // The factor multiplies the capped force. Then follow the slew limit, which starts from the sent
  // force, and the limit of the magnitude.
  SafetySettings settings = whole();
  settings.controlPassivity = false;
  settings.forceFactor = 0.5;
  settings.maximumForceRate = 1000.0; // 1 N per tick
  settings.maximumForce = 2.5;
  ChainedWall wall(settings);
  SafetyInput input = wall.at(0.0);
  EXPECT_EQ(wall.Chain.apply(input).force, Vector3d::Zero());
  const auto step = [&](double ideal, double capped)
  {
    input.time += Period;
    input.outside = false;
    input.idealForce.z() = ideal;
    input.cappedForce.z() = capped;
    return wall.Chain.apply(input);
  };
  const std::uint16_t always = flag(SafetyLink::Fit) + flag(SafetyLink::StiffnessCap);
  const std::uint16_t slewed = always + flag(SafetyLink::Slew);
  SafeForce safe = step(40.0, 1.0);
  EXPECT_EQ(safe.force.z(), 0.5);
  EXPECT_EQ(safe.forceFactor, 0.5);
  EXPECT_EQ(safe.acted, always);
  safe = step(40.0, 20.0); // 10 N requested
  EXPECT_NEAR(safe.force.z(), 1.5, 1e-10);
  EXPECT_EQ(safe.acted, slewed);
  safe = step(40.0, 20.0);
  EXPECT_NEAR(safe.force.z(), 2.5, 1e-10);
  safe = step(40.0, 20.0);
  EXPECT_NEAR(safe.force.z(), 2.5, 1e-15);
  EXPECT_EQ(safe.acted, slewed + flag(SafetyLink::Magnitude));
  safe = step(0.0, 0.0); // starts from 2.5 N, not from the value before the limit of the magnitude
  EXPECT_NEAR(safe.force.z(), 1.5, 1e-10);
  EXPECT_EQ(safe.acted, flag(SafetyLink::Fit) + flag(SafetyLink::Slew));
}

TEST(SafetyChain, PassivityIsLastAndSeesWhatIsSent)
{
  // A wall of the largest allowed stiffness, pressed 6 mm deep, with at most 2 N. The work against
  // the limited force is 2 mJ up to 2 mm and 8 mJ beyond, less the loss in the holds, plus the
  // energy that the damping dissipates at 0.05 mm per tick.
  SafetySettings settings = whole();
  settings.maximumStiffness = 1000.0;
  settings.maximumForce = 2.0;
  ChainedWall wall(settings);
  for (int i = -5; i <= 120; ++i)
  {
    const SafeForce safe = wall.feel(5e-5 * i);
    EXPECT_FALSE(safe.has(SafetyLink::Passivity)) << i;
    EXPECT_EQ(safe.has(SafetyLink::Magnitude), i > 40) << i;
  }
  const double hold = 0.5 * 1000.0 * 25e-10;
  EXPECT_NEAR(wall.Chain.energy(), 10e-3 - 40 * hold + 120 * hold, 1e-9);
}

TEST(SafetyChain, PassivityBoundsAnOverStiffWall)
{
  SafetySettings settings = whole();
  settings.maximumStiffness = 500.0;
  settings.capStiffness = false;
  ChainedWall wall(settings);
  for (int i = -5; i <= 80; ++i)
  {
    const SafeForce safe = wall.feel(5e-5 * i);
    EXPECT_EQ(safe.has(SafetyLink::Passivity), i > 0) << i;
    EXPECT_LE(safe.force.z(), std::max(0.0, 0.025 * i) + 1.1e-3); // √(2 K_max Slack) = 1 mN
    EXPECT_EQ(safe.force.z() > 0.0, i > 0);
  }
}

TEST(SafetyChain, RepeatedReadingsAreOneHold)
{
  // A device reports its position every fourth tick, each time 0.4 mm further. The work is that of
  // 4 ms. The damping dissipates a quarter of the energy that it would dissipate for the same
  // distance in 1 ms.
  ChainedWall wall(whole());
  wall.feel(0.0);
  const double way = 4e-4;
  for (int i = 1; i <= 41; ++i)
  {
    SafetyInput input = wall.at(way * (i / 4));
    input.fresh = i % 4 == 0;
    wall.Chain.apply(input);
  }
  const double work = 1000.0 * way * way * (10 * 9 / 2);
  EXPECT_NEAR(wall.Chain.energy(), work + 10 * 0.25 * 0.5 * 3000.0 * way * way, 1e-12);
}

TEST(SafetyChain, EntryRampReachesTheWholeForceAtRest)
{
  // The hand rests 4 mm deep while the force rises. This energy is granted intentionally until the
  // last step, here of half a tick. Only the energy for the present force is granted, because the
  // depth is unknown.
  SafetySettings settings = whole();
  settings.entryRamp = 499.5 * Period;
  ChainedWall wall(settings);
  wall.feel(0.0);
  for (int i = 0; i <= 520; ++i)
  {
    const double depth = std::min(4e-3, 1e-4 * (i + 1));
    SafetyInput input = wall.at(depth);
    input.depth = Infinity;
    const SafeForce safe = wall.Chain.apply(input);
    EXPECT_NEAR(safe.force.z(), 1000.0 * depth * std::min(1.0, i / 499.5), 1e-9) << i;
    EXPECT_EQ(safe.has(SafetyLink::Gate), i < 500) << i;
    EXPECT_FALSE(safe.has(SafetyLink::Passivity)) << i;
  }
}

TEST(SafetyChain, AChangeOnPurposeIsNotTakenForActivity)
{
  for (const bool onPurpose : { true, false })
  {
    SafetySettings settings = whole();
    settings.maximumForceRate = Infinity;
    ChainedWall wall(settings);
    wall.press();
    SafeForce safe;
    for (int i = 0; i <= 60; ++i)
    {
      SafetyInput input = wall.at(4e-3);
      const double stiffer = 1.0 + 1.5 * std::min(1.0, i / 50.0); // up to 2500 N/m
      input.idealForce *= stiffer;
      input.cappedForce *= stiffer;
      input.changing = onPurpose && i <= 50;
      safe = wall.Chain.apply(input);
    }
    // 7.8 mJ were put in, and the damping dissipated 0.6 mJ. They allow √(2·3000·8.4e-3) = 7.1 N,
    // 0.71 of the request. With 0.71 of the damping, √0.71 of this force is allowed.
    EXPECT_NEAR(safe.force.z(), onPurpose ? 10.0 : std::sqrt(0.71) * 7.1, onPurpose ? 1e-12 : 0.01);
  }
}

TEST(SafetyChain, ForceFactorAndStiffnessLimit)
{
  SafetySettings settings = whole();
  settings.maximumStiffness = 2000.0;
  SafetyChain chain(settings);
  EXPECT_EQ(chain.bodyStiffnessLimit(1.0), 2.0);
  EXPECT_EQ(chain.bodyStiffnessLimit(2.0), 1.0); // the hand perceives twice the stiffness of the
                                                 // body
  chain.setForceFactor(0.25);
  EXPECT_EQ(chain.bodyStiffnessLimit(1.0), 8.0);
  EXPECT_EQ(chain.settings().forceFactor, 0.25);
  chain.setForceFactor(3.0);
  EXPECT_EQ(chain.settings().forceFactor, 1.0);
  for (const double none : { 0.0, -1.0, NotANumber, -Infinity })
  {
    chain.setForceFactor(none);
    EXPECT_EQ(chain.settings().forceFactor, 0.0);
    EXPECT_EQ(chain.bodyStiffnessLimit(1.0), Infinity);
  }
  settings.capStiffness = false;
  EXPECT_EQ(SafetyChain(settings).bodyStiffnessLimit(1.0), Infinity);
}

TEST(SafetyChain, SettingsOfADevice)
{
  DeviceSpecification device;
  device.maximumForce = 3.3;
  device.maximumStiffness = 1234.0;
  device.maximumForceRate = 77.0;
  device.sampleTimeOut = 0.003;
  device.rate = 4000.0;
  const SafetySettings settings = SafetySettings::of(device);
  EXPECT_EQ(settings.maximumForce, 3.3);
  EXPECT_EQ(settings.maximumStiffness, 1234.0);
  EXPECT_EQ(settings.maximumForceRate, 77.0);
  EXPECT_EQ(settings.sampleTimeOut, 0.003);
  EXPECT_EQ(settings.period, 0.00025);
  EXPECT_EQ(settings.forceFactor, 1.0);
  EXPECT_EQ(settings.entryRamp, 0.0);
  EXPECT_TRUE(settings.gate && settings.capStiffness && settings.controlPassivity);
}

TEST(SafetyChain, MagnitudeOnlyKnowsNoTime)
{
  SafetyChain chain(SafetySettings::magnitudeOnly(5.0));
  SafetyInput input;
  input.valid = true;
  input.idealForce = Vector3d(3.0, 0.0, 4.0);
  input.cappedForce = Vector3d::Zero(); // not used
  for (const double time : { 0.0, 0.0, 7.0, -3.0, NotANumber, Infinity, 0.0 })
  {
    input.time = time;
    const SafeForce safe = chain.apply(input);
    EXPECT_EQ(safe.force, input.idealForce) << time;
    EXPECT_EQ(safe.acted, 0) << time;
  }
  input.idealForce *= 3.0;
  EXPECT_LE((chain.apply(input).force - input.idealForce / 3.0).norm(), 1e-15);
  input.idealForce.y() = NotANumber;
  EXPECT_EQ(chain.apply(input).force, Vector3d::Zero());
  input.idealForce.y() = 0.0;
  EXPECT_NEAR(chain.apply(input).force.norm(), 5.0, 1e-14);
  EXPECT_EQ(chain.bodyStiffnessLimit(1.0), Infinity);
}
} // namespace safety_chain
