// SPDX-License-Identifier: BSD-3-Clause
// The loop of a virtual spring and the simulated device becomes unstable at the limit of the exact
// theory of the zero-order hold (Data/Reference/stability_K_limits.csv; device of 0.1 kg, no hand).
// The hold creates the predicted energy.
#include "Haptics/Simulation/SimulatedDevice.h"

#include "Agreement.h"
#include "ReferenceTable.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

using namespace palpate::testing;
using Eigen::Vector3d;
using palpate::DeviceSpecification;
using palpate::HandModel;
using palpate::SimulatedDevice;
using palpate::SimulatedPlant;

namespace
{
struct Loop
{
  double period = 1e-3;
  double damping = 1.0;        ///< damping of the device, N s/m
  double virtualDamping = 0.0; ///< computed from backward differences
  double forceDelay = 0.0;
  double sampleDelay = 0.0;
};

/// Returns the positions in the first `ticks` ticks of a loop with a virtual spring about 0,
/// released at 1 mm.
std::vector<double> released(const Loop& loop, double stiffness, int ticks)
{
  SimulatedPlant plant;
  plant.mass = 0.1;
  plant.damping = loop.damping;
  plant.forceDelay = loop.forceDelay;
  plant.sampleDelay = loop.sampleDelay;
  DeviceSpecification specification;
  specification.rate = 1.0 / loop.period;
  SimulatedDevice device(plant, { 0.0, 0.0 }, { { 0.0, { 0.0, 1e-3, 0.0 } } }, specification);
  std::vector<double> positions;
  double last = 1e-3;
  for (int tick = 0; tick < ticks; ++tick)
  {
    const double x = device.read(tick * loop.period).position.y();
    const double velocity = (x - last) / loop.period;
    device.write({ 0.0, -stiffness * x - loop.virtualDamping * velocity, 0.0 });
    positions.push_back(x);
    last = x;
  }
  return positions;
}

/**
 * Determines the stability of the loop from its motion. A linear loop of order n obeys x_{k+n} = Σ
 * a_i x_{k+i}. n such equations give the characteristic polynomial z^n - Σ a_i z^i. Its roots are
 * within the unit circle if Jury's conditions hold.
 */
template <int Order>
bool isStable(const Loop& loop, double stiffness)
{
  const std::vector<double> x = released(loop, stiffness, 2 * Order + 2);
  Eigen::Matrix<double, Order, Order> past;
  Eigen::Matrix<double, Order, 1> next;
  for (int row = 0; row < Order; ++row)
  {
    for (int i = 0; i < Order; ++i)
    {
      past(row, i) = x[static_cast<std::size_t>(row + i + 2)];
    }
    next(row) = x[static_cast<std::size_t>(row + Order + 2)];
  }
  const Eigen::Matrix<double, Order, 1> c = -past.fullPivLu().solve(next);
  if constexpr (Order == 2)
  {
    return std::abs(c(0)) < 1.0 && std::abs(c(1)) < 1.0 + c(0);
  }
  else
  {
    return std::abs(c(0)) < 1.0 && 1.0 + c(2) + c(1) + c(0) > 0.0 &&
      1.0 - c(2) + c(1) - c(0) > 0.0 && std::abs(c(0) * c(2) - c(1)) < std::abs(c(0) * c(0) - 1.0);
  }
}

template <int Order>
double limit(const Loop& loop)
{
  double low = 0.2 * loop.damping / loop.period;
  double high = 30.0 * low;
  for (int i = 0; i < 45; ++i)
  {
    const double middle = 0.5 * (low + high);
    (isStable<Order>(loop, middle) ? low : high) = middle;
  }
  return low;
}

/// Returns true if the oscillation of the mass is smaller after forty thousand ticks.
bool calmsDown(const Loop& loop, double stiffness)
{
  constexpr int Ticks = 40000;
  constexpr int Window = 2000; // many periods, so that both windows contain peaks
  const std::vector<double> x = released(loop, stiffness, Ticks);
  double first = 0.0;
  double last = 0.0;
  for (int i = 0; i < Window; ++i)
  {
    first = std::max(first, std::abs(x[static_cast<std::size_t>(i)]));
    last = std::max(last, std::abs(x[static_cast<std::size_t>(Ticks - 1 - i)]));
  }
  return last < first;
}

const char* const Table = "stability_K_limits.csv";
/// The table's eigenvalues differ from its closed form by up to 4e-9.
constexpr double TableDigits = 1e-8;
/// Rounding errors of the identification, divided by bT/2m = 2.5e-4, the rate at which eigenvalues
/// change with K at 10 kHz.
constexpr double Identified = 2e-9;
} // namespace

TEST(StabilityLimit, ZeroOrderHold)
{
  const ReferenceTable table(Table);
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    Loop loop;
    loop.period = table.number(row, "T_s");
    loop.damping = table.number(row, "b_Ns_per_m");
    EXPECT_TRUE(agrees(limit<2>(loop), table.number(row, "Jury"), Identified))
      << loop.period << " s, " << loop.damping << " N s/m";
  }
}

TEST(StabilityLimit, OneTickOfDelay)
{
  const ReferenceTable table(Table);
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    Loop loop;
    loop.period = table.number(row, "T_s");
    loop.damping = table.number(row, "b_Ns_per_m");
    // The delay is in the force, in the sample, or half in each: the loop depends only on the sum.
    // The limit for a delay split into two fractions is the limit for the whole delay.
    for (const double share : { 1.0, 0.0, 0.5 })
    {
      loop.forceDelay = share * loop.period;
      loop.sampleDelay = (1.0 - share) * loop.period;
      EXPECT_TRUE(agrees(limit<3>(loop), table.number(row, "eig_delay1"), TableDigits))
        << loop.period << " s, " << loop.damping << " N s/m, " << share;
    }
  }
}

TEST(StabilityLimit, VirtualDamperByBackwardDifferences)
{
  const ReferenceTable table(Table);
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    Loop loop;
    loop.period = table.number(row, "T_s");
    loop.damping = table.number(row, "b_Ns_per_m");
    loop.virtualDamping = 0.5 * loop.damping;
    EXPECT_TRUE(agrees(limit<3>(loop), table.number(row, "eig_B=b/2"), TableDigits))
      << loop.period << " s, " << loop.damping << " N s/m";
  }
}

TEST(StabilityLimit, SwingsDieOutBelowAndGrowAbove)
{
  struct Case
  {
    double period;
    double delay;
    double stiffness; // limit of the reference, N/m
  };
  for (const Case& given : { Case{ 1e-3, 0.0, 2003.33889 }, Case{ 0.25e-3, 0.0, 8003.33 },
         Case{ 1e-3, 1e-3, 668.5 }, Case{ 0.25e-3, 0.25e-3, 2668.5 } })
  {
    Loop loop;
    loop.period = given.period;
    loop.forceDelay = given.delay;
    // At 1e-3 from the limit the oscillation changes by a factor of e^(1e-3 b T n/2m), at least 5 %
    // in these ticks. Peaks are sampled with an error of (ωT)²/8 = 0.3 %.
    EXPECT_TRUE(calmsDown(loop, 0.999 * given.stiffness)) << given.stiffness;
    EXPECT_FALSE(calmsDown(loop, 1.001 * given.stiffness)) << given.stiffness;
  }
}

TEST(StabilityLimit, TheHandCalms)
{
  // A hand is a spring and a damper in parallel with those of the device. The loop is unstable
  // without a hand and stable with a hand.
  DeviceSpecification specification;
  for (const bool isHeld : { false, true })
  {
    SimulatedPlant plant;
    SimulatedDevice device(plant, isHeld ? HandModel{ 200.0, 3.0 } : HandModel{ 0.0, 0.0 },
      { { 0.0, { 1e-4, 0.0, 0.0 } } }, specification);
    double last = 0.0;
    for (int tick = 0; tick < 5000; ++tick)
    {
      const Vector3d x = device.read(1e-3 * tick).position;
      device.write(-5000.0 * x);
      last = tick < 4000 ? 0.0 : std::max(last, std::abs(x.x()));
    }
    if (isHeld)
    {
      // At rest between the two springs: x = k x_t/(k + K).
      EXPECT_NEAR(last, 200.0 * 1e-4 / 5200.0, 1e-12);
    }
    else
    {
      EXPECT_GT(last, 1.0);
    }
  }
}

TEST(StabilityLimit, EnergyTheHoldLeaks)
{
  // A strong, well damped hand presses at speed v to a depth of 2 mm and returns at speed v. The
  // work of the motor is Σ F_k (x_{k+1} - x_k), which is F_max v T for any monotone law.
  constexpr double Period = 1e-3;
  constexpr double Depth = 2e-3;
  for (const double speed : { 0.02, 0.1 })
  {
    for (const double exponent : { 1.0, 1.5, 2.0 })
    {
      const double time = 4e-3 / speed;
      SimulatedPlant plant;
      plant.mass = 0.01;
      // The hand follows to within F/k = 3e-9 m of 2 mm, and settles within a tick.
      SimulatedDevice device(plant, { 1e9, 1e5 },
        { { 0.0, { 0, 0, Depth } }, { time, { 0, 0, -Depth } }, { 2.0 * time, { 0, 0, Depth } } });
      double work = 0.0;
      double strongest = 0.0;
      double force = 0.0;
      double last = Depth;
      for (int tick = 0; tick * Period <= 2.0 * time; ++tick)
      {
        const double z = device.read(tick * Period).position.z();
        work += force * (z - last);
        last = z;
        force = z < 0.0 ? 3.0 * std::pow(-z / Depth, exponent) : 0.0;
        strongest = std::max(strongest, force);
        device.write({ 0.0, 0.0, force });
      }
      EXPECT_GT(strongest, 2.9);
      // The tolerance is for 3e-9 m in the distance per tick, which is at least 2e-5 m.
      EXPECT_TRUE(agrees(work, strongest * speed * Period, 1e-3)) << speed << " " << exponent;
    }
  }
}
