// SPDX-License-Identifier: BSD-3-Clause
// Changes of scene and the clutch do not use the heap: nothing is allocated or freed.
#include "AllocationCount.h"
#include "SampleResponses.h"
#include "Haptics/Servo/ServoStep.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

using Eigen::Vector3d;
using namespace palpate;
using namespace palpate::testing;

TEST(TickAllocation, SwitchingAndClutching)
{
  const std::shared_ptr<const ContactBody> ball = uniformBody(icosphere(20.0, 3));
  const std::shared_ptr<const ContactBody> plate = uniformBody(subdivided(block(40, 40, 20), 4));
  ContactSettings rough;
  rough.friction.coefficient = 0.5;
  ContactSettings smooth;
  smooth.surface = ContactSurface::Smooth;
  ServoStep step(std::make_unique<ServoScene>(ball, rough), WorkspaceMapping(),
    SafetySettings::of(DeviceSpecification()), 1);
  constexpr int Changes = 60;
  std::vector<std::unique_ptr<ServoScene>> ready;
  for (int i = 0; i < Changes; ++i)
  {
    ready.push_back(std::make_unique<ServoScene>(
      i % 3 == 0 ? plate : ball, i % 2 == 0 ? rough : smooth, 1.0 / (1 + i % 4)));
  }
  std::unique_ptr<ServoScene> retired;
  int switching = 0;
  int clutched = 0;
  int forces = 0;
  int lost = 0;

  const long before = allocationCount();
  for (int tick = 0; tick < 100 * Changes; ++tick)
  {
    // Scenes change one after the other; every third change is during the ramp of the previous
    // change.
    if (tick % 100 == (tick / 100 % 3 == 2 ? 20 : 0) || (tick % 100 == 40 && tick / 100 % 3 == 0))
    {
      if (!ready.empty())
      {
        step.change(std::move(ready.back()));
        ready.pop_back();
      }
    }
    const double t = 1e-3 * tick;
    DeviceSample sample;
    sample.position = 1e-3 * (20.5 - 1.5 * std::abs(std::sin(4.0 * t))) *
      Vector3d(std::cos(t), std::sin(t) * std::cos(2.0 * t), std::sin(t) * std::sin(2.0 * t));
    sample.buttons = tick / 150 % 5 == 4 ? 1 : 0;
    sample.valid = tick % 997 != 996;
    sample.position.x() =
      tick % 1501 == 1500 ? std::numeric_limits<double>::quiet_NaN() : sample.position.x();
    sample.fresh = tick % 1200 < 1150;
    const Tick felt = step.step(sample, t);
    switching += step.isSwitching();
    clutched += felt.clutched;
    forces += felt.deviceForce.norm() > 0.0;
    lost += felt.deviceForce.norm() == 0.0 && felt.contact.normalForce > 0.0;
    if (tick == 3000)
    {
      retired = step.takeRetired();
      step.reset();
    }
    if (tick == 4000)
    {
      step.stop();
      step.start();
    }
  }
  const long after = allocationCount();
  EXPECT_EQ(after, before);
  EXPECT_TRUE(ready.empty());
  EXPECT_NE(retired, nullptr);
  EXPECT_NE(step.takeRetired(), nullptr);
  EXPECT_GT(switching, 1000); // changes of scene and uses of the clutch have occurred
  EXPECT_GT(clutched, 500);
  EXPECT_GT(forces, 1000);
  EXPECT_GT(lost, 20);
}
