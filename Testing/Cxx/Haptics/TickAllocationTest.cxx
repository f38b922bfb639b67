// SPDX-License-Identifier: BSD-3-Clause
// The tick does not use the heap: at onset, sliding, leaving, at borders, beyond the range, and for
// NaN.
#include "AllocationCount.h"
#include "CoupledPlate.h"
#include "RelaxingPlate.h"
#include "SampleResponses.h"
#include "SampleTilts.h"
#include "Contact/Coupled/CoupledContacts.h"
#include "Haptics/Servo/ServoStep.h"
#include "Haptics/Simulation/SimulatedDevice.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <new>
#include <vector>

namespace tick_allocation
{
using Eigen::Vector3d;
using namespace palpate::testing;
using palpate::ContactState;
using palpate::DeviceSample;
using palpate::NotANumber;
using palpate::ServoStep;
using palpate::SimulatedDevice;
using palpate::Tick;
using palpate::ToolContact;
using palpate::WorkspaceMapping;

namespace
{
constexpr int Ticks = 5000;

/// Number of ticks in each state, to check that the test has reached all states.
using States = std::array<int, 7>;

void met(States& states, ContactState state)
{
  ++states[static_cast<std::size_t>(state)];
}

/// Path above and below the surface of a 10 mm plate, beyond its border, up to 3 mm deep. Every
/// 97th tip is NaN.
Vector3d pathOf(int tick)
{
  const double t = 1e-3 * tick;
  const double z = tick % 97 == 0 ? NotANumber : 1.0 - 4.0 * std::abs(std::sin(5.0 * t));
  return { 5.0 + 6.0 * std::sin(3.1 * t), 5.0 + 5.5 * std::cos(1.7 * t), z };
}

void expectEverywhere(const States& states)
{
  for (const ContactState state : { ContactState::None, ContactState::Slide,
         ContactState::BeyondRange, ContactState::LostAtBorder, ContactState::Invalid })
  {
    EXPECT_GT(states[static_cast<std::size_t>(state)], 20) << static_cast<int>(state);
  }
}

/// Prevents the optimiser from removing an allocation.
void* volatile Sink = nullptr;
} // namespace

TEST(TickAllocation, TheCounterSeesAllocations)
{
  long before = allocationCount();
  Sink = ::operator new(8);
  EXPECT_EQ(allocationCount(), before + (countsMalloc() ? 2 : 1)); // new, and malloc within new
  before = allocationCount();
  ::operator delete(Sink);
  EXPECT_EQ(allocationCount(), before + 1);
  before = allocationCount();
  const Surface inALibrary = block(1, 1, 1);
  const auto mesh = inALibrary.mesh(); // allocates inside libpalpateContact
  EXPECT_GT(allocationCount(), before + 20);
  if (countsMalloc())
  {
    before = allocationCount();
    Sink = std::malloc(8);
    EXPECT_EQ(allocationCount(), before + 1);
    std::free(Sink);
  }
}

TEST(TickAllocation, ToolContact)
{
  const auto plate = uniformBody(openPlate(10.0, 20));
  const auto ball = uniformBody(icosphere(20.0, 3));
  ToolContact onPlate(*plate);
  ToolContact onBall(*ball, { palpate::ForceForm::Paper });
  States states{};
  int inside = 0;
  const long before = allocationCount();
  for (int tick = 0; tick < Ticks; ++tick)
  {
    met(states, onPlate.update(pathOf(tick)).state);
    onPlate.foresee();
    onPlate.rehearse(1e-3);
    const double t = 1e-3 * tick;
    const Vector3d tip = (20.0 - 3.0 * std::sin(7.0 * t)) *
      Vector3d(std::cos(t), std::sin(t) * std::cos(t), std::sin(t) * std::sin(t));
    inside += onBall.update(tip).normalForce > 0.0;
    if (tick % 1000 == 0)
    {
      onBall.reset();
    }
  }
  EXPECT_EQ(allocationCount(), before);
  expectEverywhere(states);
  EXPECT_GT(inside, Ticks / 4);
}

TEST(TickAllocation, OverSharpAndBluntEdges)
{
  // A block with one bevelled edge. A tip moves around it under its faces and over all its edges.
  const Surface bevelled =
    subdivided(prism({ { 0, 0 }, { 10, 0 }, { 10, 7 }, { 7, 10 }, { 0, 10 } },
                 { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 } }, 10.0),
      3);
  const auto body = uniformBody(bevelled, sphereOverEdges());
  for (const auto surface : { palpate::ContactSurface::Facets, palpate::ContactSurface::Smooth })
  {
    ToolContact contact(*body, { palpate::ForceForm::EnergyConsistent, surface });
    int inside = 0;
    const long before = allocationCount();
    for (int tick = 0; tick < Ticks; ++tick)
    {
      const double t = 3e-3 * tick;
      const Vector3d direction(
        std::cos(t) * std::cos(0.31 * t), std::sin(t) * std::cos(0.31 * t), std::sin(0.31 * t));
      const double size = direction.cwiseAbs().maxCoeff();
      const double out = 5.5 - 2.0 * std::abs(std::sin(0.17 * t));
      inside += contact.update(Vector3d::Constant(5.0) + out / size * direction).normalForce > 0.0;
      contact.foresee();
      contact.rehearse(1e-3);
    }
    EXPECT_EQ(allocationCount(), before);
    EXPECT_GT(inside, Ticks / 4);
  }
}

TEST(TickAllocation, EveryFormSurfaceAndFriction)
{
  const auto ball = uniformBody(icosphere(20.0, 3));
  for (const auto form : { palpate::ForceForm::Paper, palpate::ForceForm::NormalizedDirection,
         palpate::ForceForm::EnergyConsistent })
  {
    for (const auto surface : { palpate::ContactSurface::Facets, palpate::ContactSurface::Smooth })
    {
      for (const auto model : { palpate::FrictionModel::ElastoPlastic, palpate::FrictionModel::Dahl,
             palpate::FrictionModel::ShapeDerived })
      {
        palpate::ContactSettings settings{ form, surface };
        settings.friction.model = model;
        settings.friction.coefficient = 0.5;
        ToolContact contact(*ball, settings);
        int inside = 0;
        const long before = allocationCount();
        for (int tick = 0; tick < Ticks / 10; ++tick)
        {
          const double t = 1e-2 * tick;
          const Vector3d tip = (20.0 - 3.0 * std::sin(7.0 * t)) *
            Vector3d(std::cos(t), std::sin(t) * std::cos(t), std::sin(t) * std::sin(t));
          inside += contact.update(tip).friction.norm() > 0.0;
        }
        EXPECT_EQ(allocationCount(), before);
        EXPECT_GT(inside, Ticks / 40);
      }
    }
  }
}

TEST(TickAllocation, OfABodyThatRelaxes)
{
  RelaxingPlate plate(1.5, relaxation({ { 1.0, 0.02 }, { 0.5, 0.5 } }));
  plate.terms.radius = 2.0;
  std::vector<float> strength(2 * plate.surface.points.size(), 0.5F);
  const std::vector<float> compliance(plate.surface.points.size(), 0.2F);
  for (const int kind : { 0, 1, 2 })
  {
    plate.terms.strength = kind == 1 ? strength.data() : nullptr;
    plate.terms.elasticCompliance = kind == 2 ? compliance.data() : nullptr;
    const auto body = plate.body();
    for (const int elements : { 0, 16, 32 })
    {
      palpate::ContactSettings settings;
      settings.form = palpate::ForceForm::EnergyConsistent;
      settings.friction.coefficient = 0.3;
      settings.relaxationElements = elements;
      ToolContact contact(*body, settings);
      States states{};
      int remembered = 0;
      const long before = allocationCount();
      for (int tick = 0; tick < Ticks; ++tick)
      {
        const Vector3d tip = 6.0 * pathOf(tick) + Vector3d(0.0, 0.0, -5.6);
        const palpate::Contact felt = contact.update(tip, 1e-3);
        remembered += felt.memory > 0.0;
        const double share = contact.cappedShare(felt, 1.0);
        met(states, share >= 0.0 ? felt.state : ContactState::Stick);
        if (tick % 700 == 0)
        {
          contact.lose();
          contact.pass(1e-3);
        }
      }
      EXPECT_EQ(allocationCount(), before);
      EXPECT_GT(remembered, 100);
      EXPECT_GT(states[static_cast<std::size_t>(ContactState::None)], 20);
    }
  }
}

TEST(TickAllocation, OfAToolThatLeans)
{
  const TiltStore tilts({ [](double depth, double angle) { return 1.0 + depth * angle; } },
    dropOfSphere(5.0), 2.0, 0.5);
  for (const bool relaxes : { false, true })
  {
    const RelaxingPlate plate(
      1.5, relaxes ? relaxation({ { 1.0, 0.02 } }) : palpate::PronySeries{});
    palpate::ResponseArrays arrays = plate.store.arrays();
    arrays.exponent = 1.5;
    arrays.relaxation = plate.terms;
    arrays.tilt = tilts.views;
    const auto body = contactBody(plate.surface, arrays);
    for (const palpate::ContactSettings& settings : allFormsAndSurfaces())
    {
      ToolContact contact(*body, settings);
      States states{};
      int turned = 0;
      const long before = allocationCount();
      for (int tick = 0; tick < Ticks; ++tick)
      {
        const Vector3d tip = 6.0 * pathOf(tick) + Vector3d(0.0, 0.0, -5.6);
        const Vector3d axis(0.7 * std::sin(0.01 * tick), 0.3 * std::cos(0.013 * tick), 1.0);
        const palpate::Contact felt = contact.update(palpate::ToolPose(tip, axis), 1e-3);
        turned += felt.torque.isZero(0.0) ? 0 : 1;
        const double share = contact.cappedShare(felt, 1.0);
        met(states, share >= 0.0 ? felt.state : ContactState::Stick);
      }
      EXPECT_EQ(allocationCount(), before);
      EXPECT_GT(turned, 0);
    }
  }
}

TEST(TickAllocation, OfSeveralThatFeelOneAnother)
{
  const auto plate = CoupledPlate().body();
  palpate::ContactSettings settings;
  settings.form = palpate::ForceForm::EnergyConsistent;
  palpate::CoupledContacts contacts(*plate, settings, 5);
  palpate::CoupledContacts copies(contacts);
  States states{};
  int sunk = 0;
  const long before = allocationCount();
  for (int tick = 0; tick < Ticks; ++tick)
  {
    std::array<palpate::ToolPose, 5> poses{ palpate::ToolPose(6.0 * pathOf(tick)),
      palpate::ToolPose(6.0 * pathOf(tick + 40) + Vector3d(0.0, 0.0, -5.6)),
      palpate::ToolPose(6.0 * pathOf(tick + 80) + Vector3d(0.0, 0.0, -5.6)),
      palpate::ToolPose(6.0 * pathOf(tick + 120) + Vector3d(0.0, 0.0, -5.6)),
      palpate::ToolPose(Vector3d(31.0, 29.0, -0.5)) };
    const bool isSettled = tick % 50 == 0;
    const auto& felt =
      isSettled ? contacts.settle(poses.data(), 1e-3) : contacts.update(poses.data(), 1e-3);
    contacts.foresee();
    copies.assume(contacts);
    const double share = contacts.cappedShare(0, 1.0);
    met(states, share >= 0.0 ? felt[1].state : ContactState::Stick);
    sunk += contacts.sunk(4) > 0.0;
    if (tick % 700 == 0)
    {
      contacts.lose(1);
      contacts.reset();
    }
  }
  EXPECT_EQ(allocationCount(), before);
  expectEverywhere(states);
  EXPECT_GT(sunk, Ticks / 4);
}

TEST(TickAllocation, DeviceToForceToDevice)
{
  const auto plate = uniformBody(openPlate(10.0, 20));
  std::vector<SimulatedDevice::WayPoint> path;
  for (int tick = 0; tick < Ticks; ++tick)
  {
    path.push_back({ 1e-3 * tick, pathOf(tick) / 1000.0 });
  }
  SimulatedDevice device(path);
  ServoStep step(*plate, WorkspaceMapping(), 5.0);
  States states{};
  int forces = 0;
  const long before = allocationCount();
  for (int tick = -10; tick < Ticks + 10; ++tick)
  {
    const double time = tick == 1234 ? NotANumber : 1e-3 * tick;
    DeviceSample sample = device.read(time);
    sample.valid = sample.valid && tick % 113 != 0;
    const Tick done = step.step(sample, time);
    device.write(done.deviceForce);
    step.foresee();
    step.rehearse(sample, time + 1e-3);
    met(states, done.contact.state);
    forces += device.lastForce().norm() > 0.0;
  }
  EXPECT_EQ(allocationCount(), before);
  expectEverywhere(states);
  EXPECT_GT(forces, Ticks / 4);
}

TEST(TickAllocation, OfADeviceThatTurnsAndIsSentTorque)
{
  const std::shared_ptr<const palpate::ContactBody> plate = uniformBody(openPlate(10.0, 20));
  palpate::SafetySettings settings;
  settings.maximumTorque = 0.1;
  settings.maximumTorqueRate = 10.0;
  ServoStep step(std::make_unique<palpate::ServoScene>(plate), WorkspaceMapping(), settings);
  int valid = 0;
  const long before = allocationCount();
  for (int tick = 0; tick < Ticks; ++tick)
  {
    DeviceSample sample;
    sample.position = pathOf(tick) / 1000.0;
    sample.valid = true;
    sample.orientation = tick % 31 == 0 ? palpate::orientationNotTold()
                                        : palpate::turnedBy(Vector3d(0.3 * std::sin(0.01 * tick),
                                            tick % 41 == 0 ? NotANumber : 0.1, 0.0));
    valid += step.step(sample, 1e-3 * tick).valid;
  }
  EXPECT_EQ(allocationCount(), before);
  EXPECT_GT(valid, Ticks / 2);
}

TEST(TickAllocation, OfSeveralDevicesOnOneBody)
{
  const std::shared_ptr<const palpate::ContactBody> plate = CoupledPlate().body();
  palpate::ContactSettings rough;
  rough.friction.coefficient = 0.3;
  const auto scene = [&] { return std::make_unique<palpate::ServoScene>(plate, rough, 1.0, 3); };
  const palpate::SafetySettings safety = palpate::SafetySettings::of({});
  ServoStep step(scene(), { { {}, safety, 1 }, { {}, safety }, { {}, safety } });
  std::array<std::unique_ptr<palpate::ServoScene>, 3> next{ scene(), scene(), scene() };
  std::array<int, 3> forces{};
  int ramped = 0;
  States states{};
  const long before = allocationCount();
  for (int tick = 0; tick < Ticks; ++tick)
  {
    std::array<DeviceSample, 3> samples;
    for (int i = 0; i < 3; ++i)
    {
      const Vector3d tip = 6.0 * pathOf(tick + 40 * i) + Vector3d(0.0, 0.0, i == 0 ? 0.0 : -5.0);
      DeviceSample& sample = samples[static_cast<std::size_t>(i)];
      sample.position = tip / 1000.0;
      sample.valid = tick % (113 + i) != 0;
      sample.fresh = tick % 700 > 50;
      sample.buttons = tick / 150 % 5 == 4 ? 1 : 0;
    }
    std::array<Tick, 3> ticks;
    step.rehearse(samples.data(), 1e-3 * tick, ticks.data());
    step.step(samples.data(), 1e-3 * tick, ticks.data());
    step.foresee();
    for (std::size_t i = 0; i < 3; ++i)
    {
      forces[i] += ticks[i].deviceForce.norm() > 0.0;
      met(states, ticks[i].contact.state);
    }
    // Two scenes wait, and the last replaces the other.
    if (tick == 2000 || tick == 2020 || tick == 2040)
    {
      step.change(std::move(next[static_cast<std::size_t>(tick - 2000) / 20]));
    }
    ramped += ticks[2].sceneShare < 1.0;
    if (tick % 900 == 899)
    {
      step.stop(1);
      step.start(1);
    }
  }
  EXPECT_EQ(allocationCount(), before);
  EXPECT_FALSE(step.isSwitching());
  EXPECT_GT(ramped, 90); // two ramps of 50 ticks, without the ticks in which the hand was missing
  expectEverywhere(states);
  EXPECT_GT(*std::min_element(forces.begin(), forces.end()), 100);
}
} // namespace tick_allocation
