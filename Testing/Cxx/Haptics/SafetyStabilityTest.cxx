// SPDX-License-Identifier: BSD-3-Clause
// A sampled spring stiffer than 2b/T acts on a mass without a hand. Its oscillation grows without
// passivity control and decays with passivity control. A spring of the largest allowed stiffness is
// not changed.
#include "Haptics/Simulation/PlantAxis.h"
#include "Haptics/Safety/SafetyChain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace safety_stability
{
using namespace palpate;

namespace
{
constexpr double Period = 1e-3;                     // s
constexpr double Mass = 0.1;                        // kg
constexpr double Damping = 1.0;                     // N s/m
constexpr double Stiffest = 2.0 * Damping / Period; // 2b/T, N/m
constexpr double Critical = 2003.33889;             // exact, stability_K_limits.csv
constexpr HandModel Nobody{ 0.0, 0.0 };             // no spring, no damper
constexpr SimulatedPlant Plant{ Mass, Damping };

struct Course
{
  double first = 0.0;  ///< largest speed in the first tenth, m/s
  double last = 0.0;   ///< largest speed in the last tenth, m/s
  double growth = 0.0; ///< largest increase of ½mv² + E in a tick, J
  double push = 0.0;   ///< largest force of the chain, N
  int acted = 0;       ///< number of ticks in which the control acted
};

enum class Spring
{
  Wall, ///< only for x < 0
  Both  ///< on both sides of 0
};

/// The mass moves towards a spring at 0.1 m/s, and a constant force pushes it towards the spring.
Course throwAt(Spring kind, double stiffness, bool controlled, double push, int ticks)
{
  SafetySettings settings;
  settings.maximumForce = 1e6;
  settings.maximumStiffness = Stiffest;
  settings.period = Period;
  settings.capStiffness = false;
  settings.controlPassivity = controlled;
  SafetyChain chain(settings);
  PlantAxis axis(Plant, Nobody);
  PlantAxis::State state{ 1e-4, -0.1 };
  Course result;
  double before = 1.0;
  for (int i = 0; i < ticks; ++i)
  {
    SafetyInput input;
    input.time = Period * i;
    input.valid = true;
    input.position.x() = state.position;
    const bool touches = state.position < 0.0 || (kind == Spring::Both && i > 0);
    input.outside = !touches;
    input.idealForce.x() = touches ? -stiffness * state.position : 0.0;
    input.cappedForce = input.idealForce;
    input.depth = std::abs(state.position);
    const SafeForce safe = chain.apply(input);
    const double whole = 0.5 * Mass * state.velocity * state.velocity + chain.energy();
    if (i > 0 && push == 0.0)
    {
      result.growth = std::max(result.growth, whole - before);
    }
    before = whole;
    result.acted += safe.has(SafetyLink::Passivity);
    result.push = std::max(result.push, safe.force.norm());
    state = axis.advance(state, { safe.force.x() - push, 0.0, 0.0 }, Period);
    double& speed = i < ticks / 10 ? result.first : result.last;
    speed =
      i < ticks / 10 || i >= ticks - ticks / 10 ? std::max(speed, std::abs(state.velocity)) : 0.0;
  }
  return result;
}
} // namespace

TEST(SafetyStability, AnActiveSpringGrowsWithoutTheControlAndDiesWithIt)
{
  for (const double share : { 1.1, 2.0, 5.0 })
  {
    const Course loose = throwAt(Spring::Both, share * Stiffest, false, 0.0, 2000);
    const Course held = throwAt(Spring::Both, share * Stiffest, true, 0.0, 2000);
    EXPECT_GT(loose.last, 1.5 * loose.first) << share;
    EXPECT_LT(held.last, 0.02 * held.first) << share;
    EXPECT_GT(held.acted, 10) << share;
    // The sum of kinetic and stored energy never increases. This is the proof of PassivityControl,
    // checked with the energies of the plant. The Slack is 1e-9 J.
    EXPECT_LE(held.growth, 2e-9) << share;
  }
}

TEST(SafetyStability, AWallPressedByAConstantForce)
{
  // 0.5 N press the mass against a wall. If the wall is stiffer than 2b/T, the mass bounces
  // endlessly, with increasing height.
  for (const double share : { 1.5, 2.0, 5.0 })
  {
    const Course loose = throwAt(Spring::Wall, share * Stiffest, false, 0.5, 5000);
    const Course held = throwAt(Spring::Wall, share * Stiffest, true, 0.5, 5000);
    EXPECT_GT(loose.last, 0.05) << share;
    EXPECT_LT(held.last, 0.1 * loose.last) << share;
  }
}

TEST(SafetyStability, NothingIsTouchedUpToTheLimit)
{
  for (const double stiffness : { 200.0, 1000.0, Stiffest })
  {
    for (const Spring kind : { Spring::Wall, Spring::Both })
    {
      const Course loose = throwAt(kind, stiffness, false, 0.5, 3000);
      const Course held = throwAt(kind, stiffness, true, 0.5, 3000);
      EXPECT_EQ(held.acted, 0) << stiffness;
      EXPECT_EQ(held.last, loose.last) << stiffness;
      EXPECT_EQ(held.push, loose.push) << stiffness;
    }
  }
  // The plant is the plant of the table: stable just below the critical stiffness, unstable just
  // above.
  const Course below = throwAt(Spring::Both, 0.998 * Critical, false, 0.0, 20000);
  const Course above = throwAt(Spring::Both, 1.002 * Critical, false, 0.0, 20000);
  EXPECT_LT(below.last, below.first);
  EXPECT_GT(above.last, above.first);
}
} // namespace safety_stability
