// SPDX-License-Identifier: BSD-3-Clause
// With x_t the hand's target, e = x - x_t and w = dx/dt - v_t, the equation between two events is
//   e' = w,  w' = G - κe - βw,   κ = k/m, β = (b + b_hand)/m, G = (F - f_c sign v - b v_t)/m.
// Let s be the response of this equation to a unit impulse and S = ∫s. Then
//   e(h) = e + s w + S (G - κe),   w(h) = w + s (G - κe) - (βs + κS) w.
#include "Haptics/Simulation/PlantAxis.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr int MaximumStretches = 1000;
constexpr int MaximumEvents = 32;
constexpr int Bisections = 40;
/// Longest interval, in radians of the hand's own oscillation, that is checked for events only at
/// its end. The velocity changes its sign at most once in such an interval.
constexpr double LongestAngle = 0.5;

int sign(double value)
{
  return value > 0.0 ? 1 : value < 0.0 ? -1 : 0;
}

PlantAxis::Load later(PlantAxis::Load load, double duration)
{
  load.target += load.targetVelocity * duration;
  return load;
}

/// Returns (1 - e^-x)/x.
double meanDecay(double x)
{
  return x == 0.0 ? 1.0 : -std::expm1(-x) / x;
}

/// Computes the response by the power series of the impulse response, accurate for short durations.
/// With βh < 1 and κh² < 1 the truncated term is below 1e-18 of the first term.
PlantAxis::Response shortResponse(double kappa, double beta, double duration)
{
  constexpr int Terms = 24;
  const double damping = beta * duration;
  const double stiffness = kappa * duration * duration;
  double before = 0.0;
  double term = duration;
  double impulse = 0.0;
  double step = 0.0;
  for (int n = 1; n <= Terms; ++n)
  {
    impulse += term;
    step += term / (n + 1);
    // The next coefficient follows from s'' = -βs' - κs.
    const double next = -(damping * n * term + stiffness * before) / (n * (n + 1));
    before = term;
    term = next;
  }
  return { impulse, duration * step };
}

/// Computes the response in closed form, accurate for long durations.
PlantAxis::Response longResponse(double kappa, double beta, double duration)
{
  const double a = 0.5 * beta;
  const double square = a * a - kappa;
  if (square < 0.0) // underdamped
  {
    const double omega = std::sqrt(-square);
    const double decay = std::exp(-a * duration);
    const double impulse = decay * std::sin(omega * duration) / omega;
    return { impulse, (1.0 - decay * std::cos(omega * duration) - a * impulse) / kappa };
  }
  const double q = std::sqrt(square);
  const double fast = a + q;
  const double slow = kappa / fast;
  const double slowDecay = std::exp(-slow * duration);
  const double impulse = slowDecay * duration * meanDecay(2.0 * q * duration);
  if (q > 0.5 * a) // the two modes are distinct
  {
    const double difference = meanDecay(slow * duration) - meanDecay(fast * duration);
    return { impulse, duration * difference / (2.0 * q) };
  }
  const double both = slowDecay + std::exp(-fast * duration);
  return { impulse, (1.0 - 0.5 * both - a * impulse) / kappa };
}
} // namespace

PlantAxis::PlantAxis(const SimulatedPlant& plant, const HandModel& hand)
  : Plant(plant)
  , Hand(hand)
  , IsHeld(hand.stiffness > 0.0 || hand.damping > 0.0)
  , HasEvents(plant.friction > 0.0 || (this->IsHeld && std::isfinite(hand.maximumForce)))
  , LongestStretch(this->HasEvents && hand.stiffness > 0.0
        ? LongestAngle * std::sqrt(plant.mass / hand.stiffness)
        : std::numeric_limits<double>::infinity())
{
}

PlantAxis::State PlantAxis::advance(State state, Load load, double duration) noexcept
{
  if (!this->HasEvents)
  {
    return this->move(Regime(), state, load, duration);
  }
  const double longest = std::max(this->LongestStretch, duration / MaximumStretches);
  Regime regime = this->regimeAt(state, load);
  double left = duration;
  for (int events = 0; left > 0.0;)
  {
    if (events == MaximumEvents)
    {
      return this->move(regime, state, load, left);
    }
    const double span = regime.sticks
      ? this->holdingTime(state, load, left)
      : this->stretchEnd(regime, state, load, std::min(left, longest));
    state = this->move(regime, state, load, span);
    load = later(load, span);
    left -= span;
    if (!regime.sticks && !this->leaves(regime, state, load))
    {
      continue;
    }
    ++events;
    if (regime.sticks)
    {
      // The threshold is only reached, not exceeded. Therefore regimeAt would still return
      // sticking.
      regime = this->regimeAt(state, load);
      regime.sticks = false;
      regime.slide = sign(load.targetVelocity);
      continue;
    }
    if (regime.slide * state.velocity < 0.0)
    {
      state.velocity = 0.0;
    }
    regime = this->regimeAt(state, load);
  }
  return state;
}

double PlantAxis::handForce(const State& state, const Load& load) const noexcept
{
  return std::clamp(
    this->unlimitedForce(state, load), -this->Hand.maximumForce, this->Hand.maximumForce);
}

/// The force that the hand would exert without its limit, N.
double PlantAxis::unlimitedForce(const State& state, const Load& load) const noexcept
{
  return this->Hand.stiffness * (load.target - state.position) +
    this->Hand.damping * (load.targetVelocity - state.velocity);
}

PlantAxis::Regime PlantAxis::regimeAt(const State& state, const Load& load) const noexcept
{
  Regime regime;
  const double unlimited = this->unlimitedForce(state, load);
  if (std::abs(unlimited) > this->Hand.maximumForce)
  {
    regime.limit = sign(unlimited);
  }
  if (this->Plant.friction > 0.0)
  {
    const double drive = load.force + this->handForce(state, load);
    regime.sticks = state.velocity == 0.0 && std::abs(drive) <= this->Plant.friction;
    regime.slide = regime.sticks ? 0 : state.velocity != 0.0 ? sign(state.velocity) : sign(drive);
  }
  return regime;
}

bool PlantAxis::leaves(const Regime& regime, const State& state, const Load& load) const noexcept
{
  const double unlimited = this->unlimitedForce(state, load);
  const bool changesLimit = regime.limit == 0 ? std::abs(unlimited) > this->Hand.maximumForce
                                              : regime.limit * unlimited < this->Hand.maximumForce;
  return changesLimit || regime.slide * state.velocity < 0.0;
}

PlantAxis::State PlantAxis::move(
  const Regime& regime, const State& state, const Load& load, double duration) noexcept
{
  if (regime.sticks)
  {
    return state;
  }
  const bool isSprung = this->IsHeld && regime.limit == 0;
  const double mass = this->Plant.mass;
  const double kappa = isSprung ? this->Hand.stiffness / mass : 0.0;
  const double beta = (this->Plant.damping + (isSprung ? this->Hand.damping : 0.0)) / mass;
  const double origin = isSprung ? load.target : state.position;
  const double drift = isSprung ? load.targetVelocity : 0.0;
  const double push = regime.limit == 0 ? 0.0 : regime.limit * this->Hand.maximumForce;
  const double friction = regime.slide * this->Plant.friction;

  const Response response = this->respond(kappa, beta, duration);
  const double e = state.position - origin;
  const double w = state.velocity - drift;
  const double g = (load.force + push - friction - this->Plant.damping * drift) / mass - kappa * e;
  const double eEnd = e + response.impulse * w + response.step * g;
  const double wEnd =
    w + response.impulse * g - (beta * response.impulse + kappa * response.step) * w;
  return { origin + drift * duration + eEnd, drift + wEnd };
}

double PlantAxis::stretchEnd(
  const Regime& regime, const State& state, const Load& load, double duration) noexcept
{
  const auto leavesBy = [&](double time)
  { return this->leaves(regime, this->move(regime, state, load, time), later(load, time)); };
  if (!leavesBy(duration))
  {
    return duration;
  }
  double before = 0.0;
  double after = duration;
  for (int i = 0; i < Bisections; ++i)
  {
    const double middle = 0.5 * (before + after);
    (leavesBy(middle) ? after : before) = middle;
  }
  return after;
}

double PlantAxis::holdingTime(const State& state, const Load& load, double duration) const noexcept
{
  // While the mass is at rest, the hand's force changes at a constant rate.
  const double rate = this->Hand.stiffness * load.targetVelocity;
  if (rate == 0.0)
  {
    return duration;
  }
  const double needed = sign(rate) * this->Plant.friction - load.force;
  if (sign(rate) * needed >= this->Hand.maximumForce)
  {
    return duration;
  }
  return std::clamp((needed - this->unlimitedForce(state, load)) / rate, 0.0, duration);
}

PlantAxis::Response PlantAxis::respond(double kappa, double beta, double duration) noexcept
{
  if (kappa != this->LastKappa || beta != this->LastBeta || duration != this->LastDuration)
  {
    const bool isShort = beta * duration < 1.0 && kappa * duration * duration < 1.0;
    this->Last =
      isShort ? shortResponse(kappa, beta, duration) : longResponse(kappa, beta, duration);
    this->LastKappa = kappa;
    this->LastBeta = beta;
    this->LastDuration = duration;
  }
  return this->Last;
}
} // namespace palpate
