// SPDX-License-Identifier: BSD-3-Clause
// The loop of a torsion spring and a simulated device that turns. Its oscillation grows beyond the
// limit of the theory (Data/Reference/stability_K_limits.csv), and decays with the chain.
#include "Haptics/Safety/SafetyChain.h"
#include "Haptics/Simulation/SimulatedDevice.h"

#include "ReferenceTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

using namespace palpate;
using namespace palpate::testing;
using Eigen::Vector3d;

namespace
{
/// The table is for 0.1 kg and damping b in N s/m. The equations of motion are linear, so the
/// limits are proportional to inertia and damping.
constexpr double Like = 1e-3; // kg m² per kg
constexpr double Inertia = Like * 0.1;
constexpr double Start = 0.1; // rad

SimulatedDevice deviceOf(double period, double damping)
{
  SimulatedPlant plant;
  plant.inertia = Inertia;
  plant.turnDamping = damping;
  HandModel nobody{ 0.0, 0.0 };
  nobody.turnStiffness = 0.0;
  nobody.turnHandDamping = 0.0;
  const Vector3d tilted(0.0, -std::sin(Start), std::cos(Start)); // tilted by Start about x
  return { plant, nobody, { { 0.0, Vector3d::Zero(), tilted } },
    specificationOf(plant, 1.0 / period) };
}

double angleOf(const DeviceSample& sample)
{
  return turnBetween(ToolOrientation::Identity(), sample.orientation).x();
}

struct Swing
{
  double first = 0.0; ///< largest angle in the first tenth of the time
  double last = 0.0;  ///< largest angle in the last tenth of the time
};

/// Releases the device at a torsion spring about the upright orientation, optionally with the
/// chain.
Swing swing(double period, double damping, double stiffness, SafetyChain* chain, int ticks)
{
  SimulatedDevice device = deviceOf(period, damping);
  Swing result;
  for (int i = 0; i < ticks; ++i)
  {
    const double time = period * i;
    const DeviceSample sample = device.read(time);
    const double angle = angleOf(sample);
    Wrench sent{ Vector3d::Zero(), Vector3d(-stiffness * angle, 0.0, 0.0) };
    if (chain)
    {
      SafetyInput input;
      input.time = time;
      input.valid = sample.valid;
      input.position = sample.position;
      input.orientation = sample.orientation;
      input.outside = i == 0; // the first torque is counted as the energy of the spring
      input.changing = i == 1;
      input.idealTorque = input.cappedTorque = sent.torque;
      sent.torque = chain->apply(input).torque;
    }
    device.writeWrench(sent);
    double& largest = i < ticks / 2 ? result.first : result.last;
    if (i < ticks / 10 || i >= ticks - ticks / 10)
    {
      largest = std::max(largest, std::abs(angle));
    }
  }
  return result;
}
} // namespace

TEST(TurningLimit, RingsBeyondWhatTheTableSays)
{
  const ReferenceTable table("stability_K_limits.csv");
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double period = table.number(row, "T_s");
    const double damping = Like * table.number(row, "b_Ns_per_m");
    const double limit = Like * table.number(row, "Jury");
    // At 5 % from the limit the oscillation changes by e^(0.05 b n T/2m), which is e^±1 after this
    // number of ticks.
    const int ticks = static_cast<int>(40.0 * Inertia / (damping * period));
    const Swing below = swing(period, damping, 0.95 * limit, nullptr, ticks);
    const Swing above = swing(period, damping, 1.05 * limit, nullptr, ticks);
    EXPECT_NEAR(below.first, Start, 0.03 * Start); // the first period begins at the start angle
    EXPECT_LT(below.last, 0.6 * Start) << period << ' ' << damping;
    EXPECT_GT(above.last, 1.6 * Start) << period << ' ' << damping;
    EXPECT_GT(limit, 2.0 * damping / period); // 2b_θ/T, or slightly more
    EXPECT_LT(limit, 2.1 * damping / period);
  }
}

TEST(TurningLimit, TheChainLetsNoTorqueGrow)
{
  constexpr double Period = 1e-3;
  constexpr double Damping = 1e-3;
  const SimulatedPlant plant = []
  {
    SimulatedPlant turning;
    turning.inertia = Inertia;
    turning.turnDamping = Damping;
    return turning;
  }();
  SafetySettings settings = SafetySettings::of(specificationOf(plant, 1.0 / Period));
  EXPECT_EQ(settings.maximumTorsionalStiffness, Damping / Period);
  settings.gate = false;
  settings.maximumTorque = 1e3;
  for (const double share : { 2.2, 4.0, 10.0 })
  {
    SafetyChain chain(settings);
    const double stiffness = share * Damping / Period;
    const Swing loose = swing(Period, Damping, stiffness, nullptr, 1000);
    const Swing held = swing(Period, Damping, stiffness, &chain, 4000);
    EXPECT_GT(loose.last, 1.2 * loose.first) << share;
    EXPECT_LT(held.last, 0.1 * held.first) << share;
  }
}

TEST(TurningLimit, TheHandTurnsWhatNoTorqueDoes)
{
  // A hand of k_θ and b_θ turns the tool to its target orientation. A constant torque M tilts the
  // tool from the target by M/k_θ.
  SimulatedPlant plant;
  plant.inertia = Inertia;
  plant.turnDamping = 1e-3;
  HandModel hand;
  hand.turnStiffness = 0.4;
  hand.turnHandDamping = 0.01;
  SimulatedDevice device(plant, hand, Vector3d::Zero());
  EXPECT_FALSE(isTold(device.read(0.0).orientation));
  device.turnTo(Vector3d::UnitZ());
  device.read(1e-3);
  EXPECT_EQ(angleOf(device.read(2e-3)), 0.0);
  device.writeWrench({ Vector3d::Zero(), Vector3d(0.02, 0.0, 0.0) });
  for (int i = 3; i < 3000; ++i)
  {
    device.read(1e-3 * i);
    device.writeWrench({ Vector3d::Zero(), Vector3d(0.02, 0.0, 0.0) });
  }
  EXPECT_NEAR(angleOf(device.read(3.0)), 0.02 / 0.4, 1e-9); // e^(-kt/b) is negligible
  EXPECT_EQ(device.lastTorque().x(), 0.02);
  EXPECT_FALSE(device.writeWrench(
    { Vector3d::Zero(), Vector3d(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0) }));
}
