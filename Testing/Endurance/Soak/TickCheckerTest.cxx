// SPDX-License-Identifier: BSD-3-Clause
// The soak's checker on series of ticks. It accepts the ticks of the real servo step, in virtual
// time, and detects the faults that are added afterwards.
#include "ExpectFound.h"
#include "TickSeries.h"

#include "Haptics/Servo/ServoStep.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>

namespace palpate::endurance
{
namespace
{
/// Calls `spoil` for many ticks whose force changes, with friction and without. `spoil` gets a copy
/// of the series and the tick.
template <class Spoil>
void spoilTicks(unsigned seed, const Spoil& spoil)
{
  for (const double friction : { 0.0, 0.4 })
  {
    const TickSeries series(seed, true, friction);
    std::size_t tried = 0;
    for (std::size_t i = 1; i < TickSeries::Length; i += 127)
    {
      if (series.moves(i))
      {
        spoil(TickSeries(series), i);
        ++tried;
      }
    }
    EXPECT_GT(tried, 10U);
  }
}
} // namespace

TEST(TickChecker, AcceptsEveryTickOfTheServoStep)
{
  for (unsigned seed = 0; seed < 12; ++seed)
  {
    const TickSeries series(seed);
    const TickSeries::Finding found = series.firstFault();
    EXPECT_EQ(found.fault, TickFault::None)
      << seed << ": tick " << found.tick << ", " << found.text;
    const TickTally tally = series.tally();
    EXPECT_EQ(tally.ticks, TickSeries::Length);
    EXPECT_EQ(tally.faults, 0U);
    EXPECT_GT(tally.felt, TickSeries::Length / 4);
    EXPECT_GT(tally.changing, TickSeries::Ramp / 2);
    EXPECT_GT(tally.shut, 0U);
    EXPECT_GE(tally.lost, TickSeries::Gap);
    EXPECT_GT(tally.free, 0U);
    EXPECT_GT(tally.staleSeen, tally.felt / 2);
    EXPECT_LT(tally.limited, tally.felt / 10);
  }
}

// At large times the time steps are rounded, so the sums of shares differ.
TEST(TickChecker, AcceptsWhatComesAfterAnHour)
{
  for (const double begin : { 2000.0, 3600.0, 1e5, 1e5 + 0.7 })
  {
    for (unsigned seed = 0; seed < 16; ++seed)
    {
      const TickSeries series(seed, true, 0.4, begin);
      const TickSeries::Finding found = series.firstFault();
      EXPECT_EQ(found.fault, TickFault::None)
        << begin << ", " << seed << ": tick " << found.tick << ", " << found.text;
    }
  }
}

TEST(TickChecker, FindsAForceThatIsOneTickOld)
{
  spoilTicks(3,
    [](TickSeries stale, std::size_t i)
    {
      stale.send(i, stale.ticks[i - 1].sent);
      expectFound(stale, TickFault::Sent, i);
    });
}

TEST(TickChecker, FindsAContactThatIsOneTickOld)
{
  spoilTicks(5,
    [](TickSeries stale, std::size_t i)
    {
      const TickFacts& before = stale.ticks[i - 1];
      stale.ticks[i].contactForce = before.contactForce;
      stale.ticks[i].idealForce = before.idealForce;
      stale.send(i, before.sent);
      expectFound(stale, TickFault::Contact, i);
      // With the earlier position the tick is consistent in itself, but does not match the device.
      stale.ticks[i].tip = before.tip;
      expectFound(stale, TickFault::Tip, i);
    });
}

TEST(TickChecker, FindsTheBodyOfBeforeASwap)
{
  TickSeries series(2);
  const TickSeries unswapped(2, false);
  const std::size_t after = TickSeries::Swap + 2 * TickSeries::Ramp;
  ASSERT_GT(unswapped.ticks[after].sent.norm(), 0.01);
  for (std::size_t i = after; i < TickSeries::Length; ++i)
  {
    series.ticks[i].contactForce = unswapped.ticks[i].contactForce;
    series.ticks[i].idealForce = unswapped.ticks[i].idealForce;
    series.send(i, unswapped.ticks[i].sent);
  }
  expectFound(series, TickFault::Contact, after);
}

TEST(TickChecker, FindsASwapThatWasNotAskedFor)
{
  TickSeries series(2);
  for (std::size_t i = TickSeries::Swap - 7; i < TickSeries::Length; ++i)
  {
    series.ticks[i].scene = 1;
  }
  expectFound(series, TickFault::Scene, TickSeries::Swap - 7);
  for (std::size_t i = TickSeries::Swap - 7; i < TickSeries::Length; ++i)
  {
    series.ticks[i].scene = i < TickSeries::Swap ? 0 : 2;
  }
  expectFound(series, TickFault::Scene, TickSeries::Swap);
}

TEST(TickChecker, FindsASwapWithoutARamp)
{
  TickSeries series(2);
  const std::size_t middle = TickSeries::Swap + TickSeries::Ramp / 2;
  series.ticks[middle].idealForce = series.ticks[middle].contactForce;
  expectFound(series, TickFault::Contact, middle);
  series.ticks[middle].sceneShare = 1.0;
  expectFound(series, TickFault::Scene, middle);
}

TEST(TickChecker, FindsWhatIsNoNumber)
{
  const TickSeries series(4);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::size_t tick :
    { TickSeries::Swap - 100, TickSeries::Absent + 3, std::size_t{ 10 } })
  {
    TickSeries broken = series;
    broken.ticks[tick].sent.x() = nan;
    const TickSeries::Finding found = broken.firstFault();
    EXPECT_NE(found.fault, TickFault::None);
    EXPECT_EQ(found.tick, tick);
  }
  TickSeries broken = series;
  broken.ticks[TickSeries::Swap - 100].idealForce.z() = nan;
  expectFound(broken, TickFault::Contact, TickSeries::Swap - 100);
  broken = series;
  broken.ticks[TickSeries::Swap - 100].contactForce.z() = nan;
  expectFound(broken, TickFault::Contact, TickSeries::Swap - 100);
}

TEST(TickChecker, FindsASmallJump)
{
  const TickSeries series(6);
  for (const std::size_t tick : { TickSeries::Swap - 200, TickSeries::Swap + TickSeries::Ramp / 2,
         TickSeries::Swap + 3 * TickSeries::Ramp })
  {
    const Vector3 force = series.ticks[tick].sent;
    ASSERT_GT(force.norm(), 0.01) << tick;
    ASSERT_FALSE(series.ticks[tick].isPassivityLimited);
    TickSeries jumped = series;
    jumped.send(tick, 1.01 * force);
    expectFound(jumped, TickFault::Sent, tick);
    jumped.send(tick, Eigen::AngleAxisd(0.01, force.unitOrthogonal()) * force);
    expectFound(jumped, TickFault::Sent, tick);
    jumped.send(tick, Vector3::Zero()); // no force, without a reason
    expectFound(jumped, TickFault::Sent, tick);
  }
}

TEST(TickChecker, FindsAForceAfterALoss)
{
  const TickSeries series(7);
  // A force without a sample, in the first tick and in the last tick; and a force afterwards,
  // before the tip has been outside.
  for (const std::size_t tick : { TickSeries::Absent, TickSeries::Absent + TickSeries::Gap - 1,
         TickSeries::Absent + TickSeries::Gap + 5 })
  {
    ASSERT_TRUE(series.ticks[tick].sent.isZero(0.0));
    TickSeries held = series;
    held.send(tick, series.ticks[TickSeries::Absent - 1].sent);
    ASSERT_GT(held.ticks[tick].sent.norm(), 0.01);
    expectFound(held, TickFault::AfterLoss, tick);
    held.send(tick, Vector3(0.0, 1e-300, 0.0)); // the force must be exactly zero
    expectFound(held, TickFault::AfterLoss, tick);
  }
  TickSeries held = series;
  held.send(TickSeries::Broken, series.ticks[TickSeries::Broken - 1].sent);
  ASSERT_GT(held.ticks[TickSeries::Broken].sent.norm(), 0.01);
  expectFound(held, TickFault::AfterLoss, TickSeries::Broken);
}

TEST(TickChecker, FindsAForceOfADeviceThatHasFallenSilent)
{
  const TickSeries series(7);
  const std::size_t lost = TickSeries::Silent + 81; // 20.25 ms after the last new sample
  EXPECT_GT(series.ticks[lost - 1].sent.norm(), 0.01);
  ASSERT_TRUE(series.ticks[lost].sent.isZero(0.0));
  TickSeries held = series;
  held.send(lost, series.ticks[lost - 1].sent);
  expectFound(held, TickFault::AfterLoss, lost);
}

TEST(TickChecker, FindsFrictionOutOfTheCone)
{
  const TickSeries series(8, true, 0.4);
  std::size_t tried = 0;
  for (std::size_t i = 400; i < TickSeries::Swap; i += 127)
  {
    const TickFacts& tick = series.ticks[i];
    if (tick.contactForce.norm() < 0.01)
    {
      continue;
    }
    // The tangential part exceeds the limit of 0.4 of the normal part, because atan 0.4 = 22° and
    // the force is rotated by half a radian, in either direction.
    const Vector3 axis = tick.contactForce.unitOrthogonal();
    TickSeries turned = series;
    turned.ticks[i].contactForce = Eigen::AngleAxisd(0.5, axis) * tick.contactForce;
    turned.ticks[i].idealForce = turned.ticks[i].contactForce;
    expectFound(turned, TickFault::Contact, i);
    ++tried;
  }
  EXPECT_GT(tried, 5U);
}

TEST(TickChecker, FindsAForceThatRisesTooFast)
{
  // The tip moves 1 mm deeper from one tick to the next. The sent force rises at only 40 N/s.
  SceneSupply supply(1, Supplied::Elastic);
  const SuppliedScene scene = supply.make();
  ServoStep step(
    std::make_unique<ServoScene>(scene.kernel), TickSeries::mapping(), TickSeries::safety());
  FeltScene frictionless = scene.felt;
  frictionless.friction = 0.0;
  TickChecker checker(TickSeries::frame(), DeviceLimits{}, frictionless);
  Vector3 wanted = Vector3::Zero();
  for (int i = 0; i < 3; ++i)
  {
    const double time = i / TickSeries::Rate;
    const double high = i == 0 ? 2.0 : -2.0;
    DeviceSample sample;
    sample.valid = true;
    sample.position = TickSeries::frame().position(
      supply.centre() + (SceneSupply::Radius + high) * Vector3(0.6, 0.0, 0.8));
    const Tick made = step.step(sample, time);
    TickFacts tick = factsOf(time, sample, made.deviceForce, made);
    wanted = TickSeries::frame().axes.transpose() * made.idealForce;
    if (i < 2)
    {
      EXPECT_FALSE(checker.check(tick)) << i;
      continue;
    }
    EXPECT_NEAR(tick.sent.norm(), 2.0 * DeviceLimits{}.forceRate / TickSeries::Rate, 1e-9);
    ASSERT_GT(wanted.norm(), 2.0 * tick.sent.norm());
    tick.sent = wanted;
    tick.saidSent = wanted;
    EXPECT_EQ(checker.check(tick).fault, TickFault::Sent);
  }
}

TEST(TickChecker, LetsPassivityTakeButNotAddOrTurn)
{
  const TickSeries series(6);
  const std::size_t tick = TickSeries::Swap - 200;
  const Vector3 force = series.ticks[tick].sent;
  // Only one tick is changed, because the next tick would start from the last sent force, as the
  // slew limit does.
  const auto first = [&](const Vector3& sent)
  {
    TickSeries changed = series;
    changed.ticks.resize(tick + 1);
    changed.ticks[tick].isPassivityLimited = true;
    changed.send(tick, sent);
    return changed.firstFault().fault;
  };
  EXPECT_EQ(first(0.5 * force), TickFault::None);
  EXPECT_EQ(first(Vector3::Zero()), TickFault::None);
  EXPECT_EQ(first(1.01 * force), TickFault::Sent);
  EXPECT_EQ(first(-0.1 * force), TickFault::Sent);
  EXPECT_EQ(first(Eigen::AngleAxisd(0.01, force.unitOrthogonal()) * force), TickFault::Sent);
}

TEST(TickChecker, FindsARecordThatDiffersFromWhatWasSent)
{
  TickSeries series(6);
  series.ticks[TickSeries::Swap].saidSent.x() += 1e-12;
  expectFound(series, TickFault::Record, TickSeries::Swap);
  series.ticks[TickSeries::Swap - 1].time = series.ticks[TickSeries::Swap - 2].time;
  expectFound(series, TickFault::Time, TickSeries::Swap - 1);
}
} // namespace palpate::endurance
