// SPDX-License-Identifier: BSD-3-Clause
// One axis of the simulated device compared with closed forms of mechanics, and with small time
// steps.
#include "Haptics/Simulation/PlantAxis.h"

#include "Agreement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace palpate::testing;
using palpate::HandModel;
using palpate::PlantAxis;
using palpate::SimulatedPlant;

namespace
{
const HandModel Nobody{ 0.0, 0.0 };

SimulatedPlant plant(double mass, double damping, double friction = 0.0)
{
  SimulatedPlant made;
  made.mass = mass;
  made.damping = damping;
  made.friction = friction;
  return made;
}

/// Rounding error of a dozen operations on numbers of order one.
constexpr double Rounding = 1e-14;
} // namespace

TEST(PlantAxis, FreeMassUnderConstantForce)
{
  PlantAxis axis(plant(0.25, 0.0), Nobody);
  const auto end = axis.advance({ 1.0, 2.0 }, { 3.0 }, 0.5);
  EXPECT_DOUBLE_EQ(end.position, 1.0 + 2.0 * 0.5 + 0.5 * (3.0 / 0.25) * 0.5 * 0.5);
  EXPECT_DOUBLE_EQ(end.velocity, 2.0 + (3.0 / 0.25) * 0.5);
}

TEST(PlantAxis, MassAndDamper)
{
  for (const double duration : { 1e-9, 1e-5, 1e-3, 0.09, 0.11, 30.0, 1e9 })
  {
    PlantAxis axis(plant(0.1, 1.0), Nobody);
    const auto end = axis.advance({ 0.0, 2.0 }, { 3.0 }, duration);
    // v = F/b + (v0 - F/b) e^{-bt/m}
    const double decay = -std::expm1(-duration / 0.1);
    EXPECT_TRUE(agrees(end.velocity, 2.0 + decay * (3.0 - 2.0), Rounding));
    EXPECT_TRUE(agrees(end.position, 3.0 * duration + (2.0 - 3.0) * 0.1 * decay, Rounding));
  }
}

TEST(PlantAxis, HandSpringAndDamper)
{
  const double mass = 0.2;
  const double stiffness = 500.0;
  const double critical = 2.0 * std::sqrt(mass * stiffness);
  for (const double damping : { 0.0, 0.3 * critical, critical, 4.0 * critical })
  {
    // Half of the damping is in the device, half in the hand: both act.
    PlantAxis axis(plant(mass, 0.5 * damping), { stiffness, 0.5 * damping });
    for (const double t : { 1e-3, 0.019, 0.021, 0.11 })
    {
      const auto end = axis.advance({ 0.01, -0.3 }, { 0.0, 0.0 }, t);
      const double a = damping / (2.0 * mass);
      const double square = stiffness / mass - a * a;
      const double w = std::sqrt(std::abs(square));
      const bool isCritical = damping == critical;
      const double cosine = isCritical ? 1.0 : square > 0.0 ? std::cos(w * t) : std::cosh(w * t);
      const double sine = isCritical ? t : (square > 0.0 ? std::sin(w * t) : std::sinh(w * t)) / w;
      const double expected = std::exp(-a * t) * (0.01 * cosine + (-0.3 + a * 0.01) * sine);
      // The terms are of order 0.01 and cancel. At critical damping, the closed form would have an
      // error of the square root of the rounding error. The axis does not compute a root.
      EXPECT_NEAR(end.position, expected, 1e-2 * 10.0 * Rounding) << damping << " " << t;
    }
  }
}

TEST(PlantAxis, LagsBehindAMovingTarget)
{
  PlantAxis axis(plant(0.1, 2.0), { 400.0, 5.0 });
  // After 200 time constants of the slowest mode: k (x_t - x) = b v.
  const auto end = axis.advance({ 0.0, 0.0 }, { 0.0, 0.0, 0.3 }, 10.0);
  EXPECT_TRUE(agrees(end.velocity, 0.3, Rounding));
  EXPECT_NEAR(end.position, 0.3 * 10.0 - 2.0 * 0.3 / 400.0, 3.0 * Rounding);
}

TEST(PlantAxis, OneStepIsAsGoodAsManyPieces)
{
  PlantAxis axis(plant(0.1, 1.0), { 300.0, 5.0 });
  const PlantAxis::State start{ 0.004, 0.2 };
  const auto whole = axis.advance(start, { 0.7, 0.0, 0.1 }, 0.05);
  PlantAxis::State pieces = start;
  for (int i = 0; i < 1000; ++i)
  {
    pieces = axis.advance(pieces, { 0.7, 0.1 * i * 5e-5, 0.1 }, 5e-5);
  }
  // Rounding errors of a thousand operations.
  EXPECT_NEAR(pieces.position, whole.position, 1e-14);
  EXPECT_NEAR(pieces.velocity, whole.velocity, 1e-12);
}

TEST(PlantAxis, FrictionStopsItAndHoldsIt)
{
  PlantAxis axis(plant(0.1, 0.0, 0.4), Nobody);
  // ½ m v² = f_c x: x = 0.1·0.04/2/0.4 m, after m v/f_c = 0.05 s.
  const auto stopped = axis.advance({ 0.0, -0.2 }, { 0.0 }, 0.06);
  EXPECT_EQ(stopped.velocity, 0.0);
  EXPECT_TRUE(agrees(stopped.position, -0.005, 1e-10)); // events are located to 2^-40
  EXPECT_EQ(axis.advance(stopped, { 0.399 }, 1.0).position, stopped.position);
  EXPECT_EQ(axis.advance(stopped, { -0.399 }, 1.0).position, stopped.position);
  EXPECT_TRUE(agrees(axis.advance(stopped, { 0.6 }, 0.1).velocity, (0.6 - 0.4) / 0.1 * 0.1, 1e-12));
}

TEST(PlantAxis, FrictionTurnsWithTheMotion)
{
  PlantAxis axis(plant(0.1, 0.0, 0.4), Nobody);
  // Thrown against 1 N: decelerates at 14 m/s², returns at 6 m/s².
  const auto end = axis.advance({ 0.0, 0.7 }, { -1.0 }, 0.05 + 0.1);
  EXPECT_TRUE(agrees(end.velocity, -6.0 * 0.1, 1e-10));
  EXPECT_TRUE(agrees(end.position, 0.5 * 14.0 * 0.05 * 0.05 - 0.5 * 6.0 * 0.1 * 0.1, 1e-10));
}

TEST(PlantAxis, AMovingHandOvercomesFriction)
{
  PlantAxis axis(plant(0.1, 0.0, 0.4), { 200.0, 0.0 });
  // The spring reaches f_c when the target has moved by f_c/k = 2 mm, after 20 ms at 0.1 m/s. Then
  // m x'' = k v_t t - k x, with the solution x = v_t (t - sin(ωt)/ω).
  EXPECT_EQ(axis.advance({ 0.0, 0.0 }, { 0.0, 0.0, 0.1 }, 0.0199).position, 0.0);
  const double omega = std::sqrt(200.0 / 0.1);
  const auto end = axis.advance({ 0.0, 0.0 }, { 0.0, 0.0, 0.1 }, 0.02 + 0.03);
  EXPECT_TRUE(agrees(end.position, 0.1 * (0.03 - std::sin(omega * 0.03) / omega), 1e-9));
  // The other direction is symmetric.
  EXPECT_EQ(axis.advance({ 0.0, 0.0 }, { 0.0, 0.0, -0.1 }, 0.05).position, -end.position);
}

TEST(PlantAxis, AHandIsNotStrongerThanItsLimit)
{
  HandModel hand{ 1000.0, 0.0 };
  hand.maximumForce = 0.5;
  PlantAxis axis(plant(0.1, 0.0), hand);
  // The target is 1 m away: the force is 0.5 N.
  EXPECT_TRUE(agrees(axis.advance({ 0.0, 0.0 }, { 0.0, 1.0 }, 0.2).position, 0.1, 1e-12));
  EXPECT_EQ(axis.handForce({ 0.0, 0.0 }, { 0.0, 1.0 }), 0.5);
  EXPECT_EQ(axis.handForce({ 0.0, 0.0 }, { 0.0, -1.0 }), -0.5);
  // Released 2 mm away: 0.5 N over 1.5 mm, then a spring over 0.5 mm. The energy gives the speed at
  // the transition.
  const double reached = std::sqrt(2.0 * 0.0015 / 5.0);
  const double speed = 5.0 * reached;
  const double omega = std::sqrt(1000.0 / 0.1);
  const double quarter = std::atan2(0.0005 * omega, speed) / omega; // time to the centre
  const auto middle = axis.advance({ 0.0, 0.0 }, { 0.0, 0.002 }, reached + quarter);
  EXPECT_NEAR(middle.position, 0.002, 1e-12);
  EXPECT_TRUE(agrees(middle.velocity, std::hypot(speed, 0.0005 * omega), 1e-9));
  // A stronger motor pushes the hand away.
  EXPECT_LT(axis.advance({ 0.0, 0.0 }, { -0.6, 0.0 }, 10.0).position, -40.0);
}

TEST(PlantAxis, EverythingAtOnceAgainstSmallSteps)
{
  HandModel hand{ 800.0, 3.0 };
  hand.maximumForce = 1.2;
  const SimulatedPlant device = plant(0.1, 1.0, 0.5);
  PlantAxis axis(device, hand);
  PlantAxis::State exact{ 0.0, 0.0 };
  PlantAxis::State small{ 0.0, 0.0 };
  int limited = 0;
  int resting = 0;
  for (int tick = 0; tick < 400; ++tick)
  {
    // The target moves 8 mm in 0.1 s, rests for 0.1 s, and returns. The motor pushes at some times.
    const int phase = tick / 100;
    const double speed = phase == 0 ? 0.08 : phase == 2 ? -0.08 : 0.0;
    const double passed = 1e-3 * (tick % 100);
    const double target = phase == 0 ? speed * passed
      : phase == 2                   ? 0.008 + speed * passed
      : phase == 1                   ? 0.008
                                     : 0.0;
    const PlantAxis::Load load{ (tick / 20) % 5 == 0 ? -1.8 : 0.4, target, speed };
    exact = axis.advance(exact, load, 1e-3);
    constexpr int Steps = 2000;
    const double h = 1e-3 / Steps;
    for (int i = 0; i < Steps; ++i)
    {
      const double wish = hand.stiffness * (target + speed * i * h - small.position) +
        hand.damping * (speed - small.velocity);
      const double drive = load.force + std::clamp(wish, -1.2, 1.2) - small.velocity;
      const double before = small.velocity;
      const double free = before + h * drive / device.mass;
      const double most = h * device.friction / device.mass;
      small.velocity = std::abs(free) <= most ? 0.0 : free - std::copysign(most, free);
      small.position += h * 0.5 * (before + small.velocity);
    }
    limited += std::abs(axis.handForce(exact, load)) == 1.2;
    resting += exact.velocity == 0.0;
    // The small steps are of first order, so the difference decreases with them. It is at most
    // 1.2e-5 m/s and 1.5e-7 m for steps of half a microsecond.
    EXPECT_NEAR(exact.velocity, small.velocity, 3e-5) << tick;
    EXPECT_NEAR(exact.position, small.position, 4e-7) << tick;
  }
  EXPECT_GT(limited, 20);
  EXPECT_GT(resting, 20);
}

TEST(PlantAxis, ExtremesStayFinite)
{
  HandModel strong{ 1e9, 1e9 };
  strong.maximumForce = 3.0;
  for (const HandModel& hand : { Nobody, HandModel{ 1e9, 0.0 }, HandModel{ 0.0, 1e9 }, strong })
  {
    for (const double friction : { 0.0, 1e9 })
    {
      for (const double duration : { 0.0, 1e-300, 1e-3, 1e3, 1e9 })
      {
        PlantAxis axis(plant(1e-6, 1.0, friction), hand);
        const auto end = axis.advance({ 0.1, 0.1 }, { 1.0, 0.0, 0.01 }, duration);
        EXPECT_TRUE(std::isfinite(end.position)) << duration;
        EXPECT_TRUE(std::isfinite(end.velocity)) << duration;
      }
    }
  }
}
