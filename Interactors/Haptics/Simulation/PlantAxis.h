// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PlantAxis_h
#define palpate_PlantAxis_h

#include "Mechanics/PalpateExport.h"
#include "Haptics/Simulation/SimulatedPlant.h"

namespace palpate
{
/**
 * The motion of one axis of a simulated device while the motor's force is constant and the hand's
 * target moves uniformly.
 *
 * Between events the equation (SimulatedPlant, HandModel) is linear with constant coefficients and
 * is integrated exactly, to rounding, for any duration. Events are the stop of the motion, the
 * overcoming of static friction, and the hand's force reaching or leaving its maximum. The times of
 * events are computed to 2^-40 of an interval. An interval is 0.08 of the hand's period, or a
 * thousandth of the duration if that is longer. Two opposite events within one interval may be
 * missed. After 32 events in one duration the last regime continues to the end of the duration.
 *
 * A call costs less than half a microsecond, and about forty times as much per event.
 */
class PALPATE_EXPORT PlantAxis
{
public:
  /// Position and velocity of the mass.
  struct State
  {
    double position = 0.0; ///< m
    double velocity = 0.0; ///< m/s
  };
  /// The loads on the mass during one tick.
  struct Load
  {
    double force = 0.0;          ///< force of the motor, constant, N
    double target = 0.0;         ///< target of the hand at the start of the tick, m
    double targetVelocity = 0.0; ///< m/s
  };

  /// The solution x of x'' = -βx' - κx at the time h after a unit impulse (s) and after a unit step
  /// (∫s).
  struct Response
  {
    double impulse = 0.0;
    double step = 0.0;
  };

  PlantAxis(const SimulatedPlant& plant, const HandModel& hand);

  State advance(State state, Load load, double duration) noexcept;
  /// Force of the hand on the device, N.
  double handForce(const State& state, const Load& load) const noexcept;

private:
  /// The form of the equation of motion between two events.
  struct Regime
  {
    bool sticks = false;
    int slide = 0; ///< direction of the motion that friction opposes; 0 without sliding
    int limit = 0; ///< sign of the hand's force if it is at its maximum, else 0
  };

  double unlimitedForce(const State& state, const Load& load) const noexcept;
  Regime regimeAt(const State& state, const Load& load) const noexcept;
  bool leaves(const Regime& regime, const State& state, const Load& load) const noexcept;
  State move(const Regime& regime, const State& state, const Load& load, double duration) noexcept;
  /// Returns the end of an interval, or the time of the first event within it.
  double stretchEnd(
    const Regime& regime, const State& state, const Load& load, double duration) noexcept;
  /// The time for which friction holds the mass, at most `duration`.
  double holdingTime(const State& state, const Load& load, double duration) const noexcept;
  Response respond(double kappa, double beta, double duration) noexcept;

  SimulatedPlant Plant;
  HandModel Hand;
  bool IsHeld;
  bool HasEvents;
  double LongestStretch; ///< s

  /// The last computed response is stored, because the axes of a device mostly need the same one.
  double LastKappa = 0.0;
  double LastBeta = 0.0;
  double LastDuration = 0.0;
  Response Last;
};
} // namespace palpate

#endif
