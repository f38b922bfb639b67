// SPDX-License-Identifier: BSD-3-Clause
// A relaxing body in the servo step: time, gaps and losses of readings, changes of body, and a
// closed loop with a mass. N, mm, s.
#include "Haptics/Servo/ServoStep.h"

#include "Haptics/Simulation/SimulatedDevice.h"
#include "ReferenceTable.h"
#include "RelaxingPlate.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace servo_relaxation
{
using Eigen::Vector3d;
using namespace palpate;
using palpate::Infinity;
using namespace palpate::testing;

namespace
{
constexpr double Period = 1e-3;

DeviceSample sampleAt(const Vector3& tip)
{
  DeviceSample sample;
  sample.position = 1e-3 * tip;
  sample.valid = true;
  sample.fresh = true;
  return sample;
}

std::unique_ptr<ServoScene> sceneOf(const RelaxingPlate& plate)
{
  return std::make_unique<ServoScene>(plate.body());
}

SafetySettings unlimited()
{
  return SafetySettings::magnitudeOnly(Infinity);
}

/// Position of a press to 1 mm that leaves and enters again, while it moves along the surface.
Vector3 pathAt(double t)
{
  return tipAt(0.8 * std::sin(9.0 * t) + 0.2, 28.0 + 3.0 * std::sin(2.0 * t), 29.1);
}
} // namespace

TEST(ServoRelaxation, TimeIsThatOfTheTicks)
{
  RelaxingPlate plate(1.5, relaxation({ { 1.0, 0.05 }, { 0.5, 0.5 } }));
  plate.terms.radius = 2.0;
  ServoStep step(sceneOf(plate), WorkspaceMapping(), unlimited());
  const auto body = plate.body();
  ToolContact contact(*body);
  double last = 0.0;
  double remembered = 0.0;
  for (int i = 0; i < 2000; ++i)
  {
    // Ticks with unequal periods.
    const double t = Period * (i + 0.3 * std::sin(static_cast<double>(i)));
    const Tick tick = step.step(sampleAt(pathAt(t)), t);
    const Contact expected = contact.update(tick.tip, i > 0 ? t - last : 0.0);
    ASSERT_EQ(tick.contact.force, expected.force) << i;
    EXPECT_EQ(tick.contact.memory, expected.memory);
    remembered = std::max(remembered, expected.memory);
    last = t;
  }
  EXPECT_GT(remembered, 0.5);
}

TEST(ServoRelaxation, TheSameTicksGiveTheSameBits)
{
  const RelaxingPlate plate(2.0, relaxation({ { 1.0, 0.05 }, { 0.5, 0.5 } }));
  ServoStep first(sceneOf(plate), WorkspaceMapping(), unlimited());
  ServoStep again(sceneOf(plate), WorkspaceMapping(), unlimited());
  for (int i = 0; i < 1000; ++i)
  {
    const double t = 1.7e-3 * i;
    EXPECT_EQ(first.step(sampleAt(pathAt(t)), t).deviceForce,
      again.step(sampleAt(pathAt(t)), t).deviceForce);
  }
}

// The material continues to relax while readings are missing. A loss ends only the contact.
TEST(ServoRelaxation, MissingReadingsPassInTime)
{
  const RelaxingPlate plate(1.5, relaxation({ { 1.0, 0.1 } }));
  SafetySettings safety = SafetySettings::magnitudeOnly(Infinity);
  ServoStep whole(sceneOf(plate), WorkspaceMapping(), safety);
  ServoStep gaps(sceneOf(plate), WorkspaceMapping(), safety);
  const auto pressed = [](int i) { return tipAt(std::min(0.02 * i - 0.1, 1.0)); };
  for (int i = 0; i < 600; ++i)
  {
    const double t = Period * i;
    const Tick truth = whole.step(sampleAt(pressed(i)), t);
    DeviceSample sample = sampleAt(pressed(i));
    // 5 ms without readings during the press. Later, at rest, one NaN and a long gap, which are
    // losses.
    sample.valid = !((i > 30 && i < 36) || (i > 200 && i < 400));
    sample.position.x() = i == 100 ? std::numeric_limits<double>::quiet_NaN() : sample.position.x();
    const Tick felt = gaps.step(sample, t);
    if (!felt.valid)
    {
      EXPECT_EQ(felt.deviceForce, Vector3d::Zero());
      continue;
    }
    // The press is uniform through the gap, so the elements are the same up to rounding. The
    // difference between chord and curve is uniform, with a relative error of up to (T/τ)².
    EXPECT_NEAR(felt.contact.normalForce, truth.contact.normalForce, 1e-4) << i;
  }
  gaps.stop();
  EXPECT_EQ(gaps.step(sampleAt(tipAt(1.0)), 0.6).deviceForce, Vector3d::Zero());
  gaps.reset();
  gaps.start();
  EXPECT_NEAR(gaps.step(sampleAt(tipAt(0.5)), 0.0).contact.memory, 0.0, 1e-9);
}

// With the complete chain, a lost reading gives the hand no energy, with and without the gate.
TEST(ServoRelaxation, ALostReadingCreatesNothing)
{
  const RelaxingPlate plate(1.5, relaxation({ { 2.0, 0.05 }, { 1.0, 0.5 } }));
  for (const bool gate : { true, false })
  {
    for (const double rate : { 0.02, 0.2 })
    {
      SafetySettings safety;
      safety.gate = gate;
      safety.maximumForce = 20.0;
      safety.maximumStiffness = 6000.0;
      safety.maximumForceRate = 1e5;
      safety.period = Period;
      ServoStep step(sceneOf(plate), WorkspaceMapping(), safety);
      double work = 0.0; // work of the hand, mJ
      Vector3d before = Vector3d::Zero();
      Vector3d force = Vector3d::Zero();
      unsigned seed = 17;
      for (int i = 0; i < 6000; ++i)
      {
        const double t = Period * i;
        const Vector3 tip = i < 5990 ? pathAt(t) : tipAt(-0.5);
        work -= i > 0 ? force.dot(1e-3 * tip - before) * 1e3 : 0.0;
        before = 1e-3 * tip;
        DeviceSample sample = sampleAt(tip);
        seed = seed * 1664525U + 1013904223U;
        sample.valid = static_cast<double>(seed >> 8) / (1 << 24) > rate;
        force = step.step(sample, t).deviceForce;
      }
      EXPECT_GE(work, 0.0) << gate << " " << rate;
    }
  }
}

// The body is changed during contact. The new body begins without memory, and the force changes to
// its force within 50 ms.
TEST(ServoRelaxation, AnotherBodyBeginsAtRest)
{
  const RelaxingPlate first(1.5, relaxation({ { 1.0, 0.2 } }));
  const RelaxingPlate second(2.0, relaxation({ { 3.0, 0.2 } }));
  ServoStep step(sceneOf(first), WorkspaceMapping(), unlimited());
  Tick tick;
  double t = 0.0;
  for (int i = 0; i < 60; ++i, t += Period)
  {
    tick = step.step(sampleAt(tipAt(0.02 * i - 0.1)), t);
  }
  const double before = tick.idealForce.norm();
  EXPECT_GT(before, 1.5);
  step.change(sceneOf(second));
  double last = before;
  double fastest = 0.0;
  for (int i = 0; i < 60; ++i, t += Period)
  {
    tick = step.step(sampleAt(tipAt(1.08)), t);
    fastest = std::max(fastest, std::abs(tick.idealForce.norm() - last));
    last = tick.idealForce.norm();
  }
  EXPECT_FALSE(step.isSwitching());
  EXPECT_NEAR(tick.contact.memory, 0.0, 1e-6);
  EXPECT_NEAR(last, 1.08 * 1.08, 2e-2); // beyond the range of 1 mm, along the tangent
  EXPECT_LT(fastest, 1.1 * std::abs(before - last) * Period / 0.05 + 0.005 * before);
}

namespace
{
/// True if a mass that a constant force presses against a body under a flat end comes to rest.
bool comesToRest(double stiffness, const PronySeries& series, double mass, double damping,
  double period, double delay)
{
  // The range is 2 mm, of which half is pressed, so the contact never ends.
  const RelaxingPlate plate(1.0, series, 2.0, [&](const Vector3&) { return 1e-3 * stiffness; });
  const auto body = plate.body();
  ToolContact contact(*body);
  SimulatedPlant plant;
  plant.mass = mass;
  plant.damping = damping;
  plant.forceDelay = delay;
  DeviceSpecification specification;
  specification.rate = 1.0 / period;
  const double rest = -1e-3; // m
  SimulatedDevice device(
    plant, { 0.0, 0.0 }, { { 0.0, { 0.0, 0.0, rest + 1e-6 } } }, specification);
  const int ticks = static_cast<int>(20.0 / period);
  const int window = ticks / 10;
  double first = 0.0;
  double last = 0.0;
  for (int tick = 0; tick < ticks; ++tick)
  {
    const double z = device.read(tick * period).position.z();
    const double force =
      contact.update({ 31.3, 29.1, 1e3 * z }, tick > 0 ? period : 0.0).normalForce;
    device.write({ 0.0, 0.0, force + stiffness * rest });
    const double swing = std::abs(z - rest);
    (tick < window ? first : last) = tick < window ? std::max(first, swing)
      : tick >= ticks - window                     ? std::max(last, swing)
                                                   : last;
    if (swing > 0.9e-3)
    {
      return false;
    }
  }
  return last < first;
}
} // namespace

// The exact limits of the sampled loop from the reference. Below the limit the mass comes to rest;
// above the limit its oscillation grows.
TEST(ServoRelaxation, LoopsAreStableToTheExactLimit)
{
  const ReferenceTable table("rate/stability_prony.csv");
  int tested = 0;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double period = table.number(row, "T_s");
    if (period < 1e-3 || table.number(row, "b") != 1.0 || table.number(row, "m_kg") != 0.1)
    {
      continue;
    }
    const PronySeries series = relaxation(table.text(row, "p"), table.text(row, "tau_s"));
    for (const bool isDelayed : { false, true })
    {
      const double limit = table.number(row, isDelayed ? "K_stable_eig_delay1" : "K_stable_eig");
      const double delay = isDelayed ? period : 0.0;
      EXPECT_TRUE(comesToRest(0.99 * limit, series, 0.1, 1.0, period, delay)) << row << isDelayed;
      EXPECT_FALSE(comesToRest(1.01 * limit, series, 0.1, 1.0, period, delay)) << row << isDelayed;
      ++tested;
    }
  }
  EXPECT_EQ(tested, 14);
}

// The chain caps the instantaneous stiffness, because it determines the stability of a loop.
TEST(ServoRelaxation, TheCapKnowsTheInstantaneousStiffness)
{
  const PronySeries series = relaxation({ { 2.0, 0.1 } });
  const RelaxingPlate plate(1.0, series, 1.0, [](const Vector3&) { return 5.0; });
  SafetySettings safety = unlimited();
  safety.capStiffness = true;
  safety.maximumStiffness = 2000.0; // N/m; divided by (1 + 2): 667 for the slow response
  ServoStep step(sceneOf(plate), WorkspaceMapping(), safety);
  double last = 0.0;
  for (int i = 0; i < 500; ++i)
  {
    const Tick tick = step.step(sampleAt(tipAt(2e-3 * i - 0.1)), Period * i);
    EXPECT_LE(tick.deviceForce.norm() - last, 1.0001 * 2.0 * 2e-3) << i;
    last = tick.deviceForce.norm();
  }
  EXPECT_GT(last, 0.8 * 0.667);
}
} // namespace servo_relaxation
