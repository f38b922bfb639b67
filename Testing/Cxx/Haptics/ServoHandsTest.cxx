// SPDX-License-Identifier: BSD-3-Clause
// Two devices on one body: the effect of one contact on the other, compared with equations solved
// by hand; separate data of each hand; loss of one device.
#include "TwoHandStep.h"

#include "Haptics/Simulation/SimulatedDevice.h"
#include "Mechanics/Numerics/Constants.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace servo_hands
{
using Eigen::Vector3d;
using namespace palpate;
using palpate::Pi;
using namespace palpate::testing;

namespace
{
constexpr double Endless = std::numeric_limits<double>::infinity();
constexpr double Spring = FlatEnds::Spring;
constexpr double Apart = FlatEnds::Apart;
constexpr double Mutual = FlatEnds::Mutual;

std::unique_ptr<ServoScene> sceneOf(
  std::shared_ptr<const ContactBody> body, const ContactSettings& settings = {})
{
  return std::make_unique<ServoScene>(std::move(body), settings, 1.0, 2);
}

std::shared_ptr<const ContactBody> flatPlate(bool isCoupled = true)
{
  return CoupledPlate(true).body(isCoupled);
}

TwoHandStep handsOn(const std::shared_ptr<const ContactBody>& body,
  const SafetySettings& safety = SafetySettings::magnitudeOnly(Endless))
{
  return { sceneOf(body), { { {}, safety }, { {}, safety } } };
}

void expectSame(const Tick& one, const Tick& other)
{
  EXPECT_EQ(one.tip, other.tip);
  EXPECT_EQ(one.contact.state, other.contact.state);
  EXPECT_EQ(one.contact.force, other.contact.force);
  EXPECT_EQ(one.idealForce, other.idealForce);
  EXPECT_EQ(one.appliedForce, other.appliedForce);
  EXPECT_EQ(one.deviceForce, other.deviceForce);
  EXPECT_EQ(one.holdTime, other.holdTime);
  EXPECT_EQ(one.acted, other.acted);
  EXPECT_EQ(one.clutched, other.clutched);
}

Vector3d wandering(int tick)
{
  const double t = 2e-3 * tick;
  return { 30.0 + 9.0 * std::sin(3.1 * t), 30.0 + 8.0 * std::cos(1.7 * t),
    0.6 - 1.4 * std::abs(std::sin(5.0 * t)) };
}
} // namespace

// One hand, or two hands on a body without coupling, give the same bits as a separate ServoStep for
// each, with a mapping that turns, all links of the chain, and the clutch.
TEST(ServoHands, EachHasTheBitsOfAStepOfItsOwnWithoutCoupling)
{
  const CoupledPlate plate;
  const std::shared_ptr<const ContactBody> body = plate.body(false);
  const std::shared_ptr<const ContactBody> coupling = plate.body(true);
  const WorkspaceMapping turned(
    Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()).toRotationMatrix(), { 5, -3, 2 }, 2.0);
  const SafetySettings safety = SafetySettings::of({});
  ContactSettings rough;
  rough.friction.coefficient = 0.4;
  const auto scene = [&](const auto& of, std::size_t hands)
  { return std::make_unique<ServoScene>(of, rough, 0.8, hands); };
  TwoHandStep hands(scene(body, 2), { { turned, safety, 1 }, { {}, safety } });
  ServoStep alone(scene(coupling, 1), { { turned, safety, 1 } });
  ServoStep first(scene(body, 1), turned, safety, 1);
  ServoStep second(scene(body, 1), {}, safety);
  int forces = 0;
  for (int tick = 0; tick < 3000; ++tick)
  {
    TwoSamples samples{ sampleOf(turned, wandering(tick)), sampleOf({}, wandering(tick + 500)) };
    samples[0].buttons = tick / 300 % 3 == 2 ? 1 : 0;
    samples[0].fresh = tick % 1000 < 960; // no new sample for longer than the time-out
    samples[1].valid = tick % 90 > 5;     // gaps
    const double time = 1e-3 * tick;
    const auto& both = hands.press(samples, time);
    const Tick one = first.step(samples[0], time);
    expectSame(alone.step(samples[0], time), one);
    if ((one.acted & static_cast<std::uint16_t>(SafetyLink::Watchdog)) == 0)
    {
      expectSame(both[0], one);
    }
    else // a device without new samples has no force, and no effect on the other
    {
      EXPECT_EQ(both[0].deviceForce, Vector3d::Zero());
      EXPECT_EQ(both[0].contact.state, ContactState::Invalid);
    }
    expectSame(both[1], second.step(samples[1], time));
    forces += both[0].deviceForce.norm() > 0.0 && both[1].deviceForce.norm() > 0.0;
  }
  EXPECT_GT(forces, 300);
}

TEST(ServoHands, TheSecondLiftsForceOffTheFirst)
{
  const auto body = flatPlate();
  TwoHandStep hands = handsOn(body);
  TwoSamples samples = FlatEnds::pressing(0.5, -1.0);
  // Rounding of floats.
  EXPECT_NEAR(hands.press(samples, 0.0)[0].deviceForce.z(), 0.5 * Spring, 1e-6);
  for (int tick = 1; tick < 200; ++tick)
  {
    const double depth = std::min(0.8, 0.008 * tick); // depth of the second hand, mm
    samples = FlatEnds::pressing(0.5, depth);
    const auto& ticks = hands.press(samples, 1e-3 * tick);
    const double first = FlatEnds::force(0.5, depth);
    const double second = FlatEnds::force(depth, 0.5);
    // 8 mm/s: with two iterations per tick, the error during motion is below 1e-4 of the force.
    // 10 ticks after the motion only the error of floats remains
    const double left = tick < 110 ? 2e-4 : 2e-6;
    if (second > 0.02)
    {
      EXPECT_NEAR(ticks[0].deviceForce.z(), first, left * Spring) << tick;
      EXPECT_NEAR(ticks[1].deviceForce.z(), second, left * Spring) << tick;
    }
  }
  // The force of the first hand is reduced by C_12 F_2 K.
  const auto& ticks = hands.ticks;
  EXPECT_NEAR(0.5 * Spring - ticks[0].deviceForce.z(), Mutual * ticks[1].deviceForce.z() * Spring,
    1e-5); // rounding of floats
  EXPECT_GT(0.5 * Spring - ticks[0].deviceForce.z(), 0.3);

  TwoHandStep apart = handsOn(flatPlate(false));
  samples = FlatEnds::pressing(0.5, 0.8);
  EXPECT_NEAR(apart.press(samples, 0.0)[0].deviceForce.z(), 0.5 * Spring, 1e-6);
}

// In the tick in which one device is lost, the other has the force of a single contact.
TEST(ServoHands, LosingOneLeavesTheOtherAlone)
{
  const auto body = flatPlate();
  SafetySettings safety = SafetySettings::of({});
  safety.maximumStiffness = Endless;
  safety.controlPassivity = false;
  enum Loss
  {
    NoSample,
    NotFinite,
    Silent,
    Stopped
  };
  for (const Loss loss : { NoSample, NotFinite, Silent, Stopped })
  {
    TwoHandStep hands = handsOn(body, safety);
    TwoSamples samples = FlatEnds::pressing(-0.5, -0.5);
    hands.press(samples, 0.0);
    samples = FlatEnds::pressing(0.5, 0.8);
    for (int tick = 1; tick < 50; ++tick)
    {
      hands.press(samples, 1e-3 * tick);
    }
    EXPECT_NEAR(hands.ticks[0].deviceForce.z(), FlatEnds::force(0.5, 0.8), 1e-5);
    EXPECT_NEAR(hands.ticks[1].deviceForce.z(), FlatEnds::force(0.8, 0.5), 1e-5);
    int tick = 50;
    samples[1].valid = loss != NoSample;
    samples[1].fresh = loss != Silent;
    samples[1].position.x() = loss == NotFinite ? std::nan("") : samples[1].position.x();
    if (loss == Stopped)
    {
      hands.stop(1);
    }
    for (; loss == Silent && tick < 49 + 20; ++tick) // the contact remains up to the time-out
    {
      hands.press(samples, 1e-3 * tick);
      EXPECT_GT(hands.ticks[1].deviceForce.z(), 0.0);
    }
    ++tick; // the time is 20 ms, or slightly more by rounding
    const auto& ticks = hands.press(samples, 1e-3 * tick);
    EXPECT_EQ(ticks[1].deviceForce, Vector3d::Zero()) << loss;
    EXPECT_NEAR(ticks[0].deviceForce.z(), 0.5 * Spring, 1e-6) << loss;
    EXPECT_EQ(ticks[0].acted, 0) << loss;
    // The device returns while the tip is inside the body. The gate is closed until the tip has
    // been outside.
    hands.start(1);
    for (int again = 1; again < 5; ++again)
    {
      samples = FlatEnds::pressing(0.5, again == 2 && loss != NoSample ? -0.5 : 0.8);
      hands.press(samples, 1e-3 * (tick + again));
      EXPECT_EQ(hands.ticks[1].deviceForce.z() > 0.0, again > 2 && loss != NoSample) << loss;
    }
  }
}

// Two flat ends at the limit of their devices. Motion in opposite directions is stiffer than a
// single contact by 1/(1 - 2a/(πr)), and the cap reduces each force by this factor.
TEST(ServoHands, TheStiffnessCapCountsBoth)
{
  SafetySettings safety = SafetySettings::magnitudeOnly(Endless);
  safety.capStiffness = true;
  safety.maximumStiffness = 2000.0; // N/m: half of the spring's stiffness
  for (const bool isCoupled : { true, false })
  {
    TwoHandStep hands = handsOn(flatPlate(isCoupled), safety);
    const TwoSamples samples = FlatEnds::pressing(0.5, 0.5);
    for (int tick = 0; tick < 20; ++tick)
    {
      hands.press(samples, 1e-3 * tick);
    }
    const double stiffer = isCoupled ? 1.0 / (1.0 - 2.0 * CoupledPlate::Flat / (Pi * Apart)) : 1.0;
    const double ideal = isCoupled ? FlatEnds::force(0.5, 0.5) : 0.5 * Spring;
    const Tick& tick = hands.ticks[0];
    EXPECT_NEAR(tick.idealForce.z(), ideal, 1e-5);
    EXPECT_NEAR(tick.deviceForce.z(), 0.5 / stiffer * ideal, 2e-5); // rounding of floats
  }
}

// Returns whether the oscillation of two masses decays. Each mass has no hand, is pressed by a
// constant force, and oscillates opposite to the other mass.
namespace
{
bool calmsDown(bool isCoupled, double stiffness)
{
  SimulatedPlant plant;
  plant.mass = 0.1;
  plant.damping = 1.0;
  const double scale = stiffness / (1000.0 * Spring);
  const WorkspaceMapping mapping(Eigen::Matrix3d::Identity(), Vector3d::Zero(), scale);
  const SafetySettings safety = SafetySettings::magnitudeOnly(Endless);
  TwoHandStep hands(sceneOf(flatPlate(isCoupled)), { { mapping, safety }, { mapping, safety } });
  const double rest = isCoupled ? FlatEnds::force(1.0, 1.0) : Spring;
  const auto device = [&](double x, double depth)
  {
    return std::make_unique<SimulatedDevice>(plant, HandModel{ 0.0, 0.0 },
      std::vector<SimulatedDevice::WayPoint>{ { 0.0, mapping.toDevice({ x, 29.3, -depth }) } });
  };
  const std::array<std::unique_ptr<SimulatedDevice>, 2> devices{ device(25.0, 1.05),
    device(25.0 + Apart, 0.95) };
  constexpr int Ticks = 20000;
  constexpr int Window = 1000;
  double first = 0.0;
  double last = 0.0;
  for (int tick = 0; tick < Ticks; ++tick)
  {
    const double time = 1e-3 * tick;
    const TwoSamples samples{ devices[0]->read(time), devices[1]->read(time) };
    const auto& ticks = hands.press(samples, time);
    for (std::size_t i = 0; i < 2; ++i)
    {
      devices[i]->write({ 0.0, 0.0, ticks[i].deviceForce.z() - rest });
    }
    const double swing = std::abs(ticks[0].tip.z() - ticks[1].tip.z());
    first = tick < Window ? std::max(first, swing) : first;
    last = tick >= Ticks - Window ? std::max(last, swing) : last;
  }
  return last < first;
}
} // namespace

// The largest stable spring of one such mass is 2003.339 N/m (stability_K_limits.csv). For two
// coupled contacts, motion in opposite directions is at this limit at 1 - 2a/(πr) times this
// stiffness.
TEST(ServoHands, OppositeMotionIsUnstableWhereItsStiffnessIs)
{
  const double limit = 2003.339;
  const double share = 1.0 - 2.0 * CoupledPlate::Flat / (Pi * Apart); // the value is 0.745
  // At 3 % from the limit, an oscillation changes by e^±3 in 20 s.
  EXPECT_TRUE(calmsDown(true, 0.97 * share * limit));
  EXPECT_FALSE(calmsDown(true, 1.03 * share * limit));
  EXPECT_TRUE(calmsDown(false, 1.03 * share * limit));
  EXPECT_TRUE(calmsDown(false, 0.97 * limit));
  EXPECT_FALSE(calmsDown(false, 1.03 * limit));
}

// Work on both devices, in device units, over a closed path, with a phase difference of a quarter
// turn. The bound is 2e-6 F δ, the reference for two iterations per tick.
TEST(ServoHands, AClosedPathOfTwoKeepsTheEnergy)
{
  const std::shared_ptr<const ContactBody> body = CoupledPlate().body();
  ContactSettings settings;
  settings.form = ForceForm::EnergyConsistent;
  const WorkspaceMapping turned(
    Eigen::AngleAxisd(0.4, Vector3d(1, -2, 1).normalized()).toRotationMatrix(), { 5, -3, 2 }, 3.0);
  const std::array<WorkspaceMapping, 2> mappings{ WorkspaceMapping(), turned };
  const SafetySettings safety = SafetySettings::magnitudeOnly(Endless);
  TwoHandStep hands(sceneOf(body, settings), { { mappings[0], safety }, { mappings[1], safety } });
  std::array<Vector3d, 2> places;
  std::array<Vector3d, 2> forces;
  double work = 0.0; // mJ, in the units of the body
  double turnedOver = 0.0;
  for (int tick = 0; tick <= 2000; ++tick)
  {
    const double angle = 2e-3 * Pi * (tick % 1000);
    TwoSamples samples;
    for (std::size_t i = 0; i < 2; ++i)
    {
      const auto hand = static_cast<double>(i);
      samples[i] = sampleOf(
        mappings[i], { 25.0 + 5.0 * hand, 29.3, -0.5 - 0.25 * std::sin(angle + 0.5 * Pi * hand) });
    }
    const auto& ticks = hands.press(samples, 1e-3 * tick);
    for (std::size_t i = 0; i < 2; ++i)
    {
      if (tick > 1000)
      {
        const double done = 1000.0 * mappings[i].scale() * 0.5 *
          (forces[i] + ticks[i].deviceForce).dot(samples[i].position - places[i]);
        work += done;
        turnedOver += std::abs(done);
      }
      places[i] = samples[i].position;
      forces[i] = ticks[i].deviceForce;
    }
  }
  const double scale = 10.0 * std::pow(0.5, 1.5) * 0.5;
  EXPECT_LT(std::abs(work), 2e-6 * scale);
  EXPECT_GT(turnedOver, scale);
}
} // namespace servo_hands
