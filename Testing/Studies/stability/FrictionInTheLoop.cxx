// SPDX-License-Identifier: BSD-3-Clause
// Part d: friction models in a sampled loop: drift under a load that oscillates within the limit,
// stick and slip behind a spring, the largest stick stiffness, and rest.
#include "Mechanics/Numerics/Constants.h"
#include "Contact/Friction.h"
#include "FrictionCurves.h"
#include "Parts.h"
#include "Haptics/Simulation/PlantAxis.h"
#include "VirtualLoop.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace palpate::testing
{
namespace
{

/// A friction model of Palpate; or, for comparison, the sign of the velocity by backward
/// differences (negative value).
struct Model
{
  std::string name;
  std::optional<FrictionSettings> settings;
};

std::vector<Model> allModels()
{
  FrictionSettings usual;
  usual.coefficient = 1.0;
  FrictionSettings creeping = usual;
  creeping.breakaway = 0.0;
  FrictionSettings hard = usual;
  hard.breakaway = 1.0;
  hard.stickRadius = 1.0;
  FrictionSettings dahl = usual;
  dahl.model = FrictionModel::Dahl;
  FrictionSettings shape = usual;
  shape.model = FrictionModel::ShapeDerived;
  return { { "elasto-plastic", usual }, { "z8", creeping }, { "stick-slide", hard },
    { "Dahl", dahl }, { "shape-derived", shape }, { "signum", std::nullopt } };
}

/// A mass along x on a plane, with a normal force of 1 N and a friction limit of 1 N, with or
/// without a hand.
class Slider
{
public:
  Slider(const Model& model, double rate, const HandModel& hand, double stickStiffness)
    : Period(1.0 / rate)
    , Axis(SimulatedPlant(), hand)
    , Curve{ 1e-3 * stickStiffness * Ratio, 1.0, 1e3 / (stickStiffness * Ratio) }
  {
    if (model.settings)
    {
      FrictionSettings settings = *model.settings;
      settings.tangentialStiffness = 1e-3 * stickStiffness;
      this->Resistance.emplace(settings);
    }
  }

  /// One tick with an outer force (N); the target of the hand is at x (m) and moves at v (m/s).
  void tick(double force, double target = 0.0, double targetVelocity = 0.0)
  {
    this->State = this->Axis.advance(
      this->State, { force + this->friction(), target, targetVelocity }, this->Period);
  }
  const PlantAxis::State& state() const { return this->State; }

private:
  /// c of ShapeFriction at ν = 0.5; it makes the stick stiffness equal to that of the other models.
  static constexpr double Ratio = 1.5;

  double friction()
  {
    const double way = this->State.position - this->Last;
    this->Last = this->State.position;
    if (!this->Resistance)
    {
      return way > 0.0 ? -1.0 : (way < 0.0 ? 1.0 : 0.0);
    }
    return this->Resistance
      ->update({ 1e3 * this->State.position, 0.0, 0.0 }, Vector3::UnitZ(), 1.0, this->Curve.depth,
        this->Curve)
      .force.x();
  }

  double Period;
  PlantAxis Axis;
  PowerCurve Curve; ///< 1 N at the full depth
  std::optional<Friction> Resistance;
  PlantAxis::State State;
  double Last = 0.0;
};

/// Drift (mm) in 8 s under 0.5 + 0.2 sin(2π 2 t) N, which is raised within 4 s: from the mean of
/// one cycle to that of another.
double drift(const Model& model, double rate)
{
  Slider slider(model, rate, Nobody, 1000.0);
  const int cycle = static_cast<int>(0.5 * rate);
  const int rise = static_cast<int>(4.0 * rate);
  double first = 0.0;
  double last = 0.0;
  const int end = rise + 17 * cycle;
  for (int i = 0; i < end; ++i)
  {
    const double time = (i - rise) / rate;
    const double grown = 0.5 - 0.5 * std::cos(Pi * std::min(1.0 + time / 4.0, 1.0));
    slider.tick(grown * (0.5 + 0.2 * std::sin(4.0 * Pi * time)));
    const double x = 1e3 * slider.state().position / cycle;
    first += i >= rise && i < rise + cycle ? x : 0.0;
    last += i >= end - cycle ? x : 0.0;
  }
  return last - first;
}

/// Motion of the last two seconds when a spring of 300 N/m pulls.
struct Slip
{
  double stuckShare = 0.0; ///< share of the time with less than a twentieth of the pull speed
  double ripple = 0.0;     ///< half of max v - min v, over the pull speed
};
Slip pulled(const Model& model, double rate, double speed)
{
  Slider slider(model, rate, { 300.0, 0.0 }, 1000.0);
  const int end = static_cast<int>((4.0 + 6e-3 / speed) * rate);
  const int counted = static_cast<int>(2.0 * rate);
  double low = 1e9;
  double high = -1e9;
  int stuck = 0;
  for (int i = 0; i < end; ++i)
  {
    slider.tick(0.0, speed * i / rate, speed);
    if (i >= end - counted)
    {
      const double v = slider.state().velocity;
      low = std::min(low, v);
      high = std::max(high, v);
      stuck += std::abs(v) < 0.05 * speed;
    }
  }
  return { static_cast<double>(stuck) / counted, 0.5 * (high - low) / speed };
}

/// The largest speed (m/s) after 3 s under half the friction limit, in half a second.
double restlessness(const Model& model, double rate, double stiffness)
{
  Slider slider(model, rate, Nobody, stiffness);
  double peak = 0.0;
  for (int i = 0; i < static_cast<int>(3.5 * rate); ++i)
  {
    slider.tick(0.5 * std::min(1.0, i / rate));
    peak =
      i < static_cast<int>(3.0 * rate) ? 0.0 : std::max(peak, std::abs(slider.state().velocity));
  }
  return peak;
}

/// Whether a stuck mass comes to rest after a speed of 1e-8 m/s. Its motion is never large enough
/// for sliding.
bool calms(const Model& model, double rate, double stiffness)
{
  LoopSetting setting;
  setting.rate = rate;
  setting.hand = Nobody;
  const int window = setting.watchedTicks() / 2;
  Slider slider(model, rate, Nobody, stiffness);
  slider.tick(0.0);
  slider.tick(1e-6);
  const auto peak = [&](int ticks)
  {
    double speed = 0.0;
    for (int i = 0; i < ticks; ++i)
    {
      slider.tick(0.0);
      speed = std::max(speed, std::abs(slider.state().velocity));
    }
    return speed;
  };
  const double first = peak(window);
  const double between = peak(2 * window);
  return peak(window) < first && std::max(first, between) < 1e-6;
}

double stiffestStick(const Model& model, double rate)
{
  double low = 0.1 * rate;
  double high = 40.0 * rate;
  for (int i = 0; i < 16; ++i)
  {
    const double middle = std::sqrt(low * high);
    (calms(model, rate, middle) ? low : high) = middle;
  }
  return low;
}

void print(const Model& model, double rate, const char* what, double setting, double value)
{
  std::printf("%s,%g,%s,%g,%.5g\n", model.name.c_str(), rate, what, setting, value);
  std::fflush(stdout);
}
} // namespace

void frictionInTheLoop(bool isQuick)
{
  std::puts("model,rate_Hz,what,setting,value");
  for (const double rate : { 1000.0, 2000.0, 4000.0, 8000.0 })
  {
    if (isQuick && rate != 1000.0)
    {
      continue;
    }
    for (const Model& model : allModels())
    {
      print(model, rate, "drift_mm", 0.0, drift(model, rate));
      for (const double speed : { 1e-3, 5e-3, 20e-3 })
      {
        const Slip slip = pulled(model, rate, speed);
        print(model, rate, "stuck_share", 1e3 * speed, slip.stuckShare);
        print(model, rate, "speed_ripple", 1e3 * speed, slip.ripple);
      }
      for (const double share : { 0.5, 0.9, 1.1, 2.0 })
      {
        // 2b/T of the plant
        print(model, rate, "rest_speed_mm_s", share,
          1e3 * restlessness(model, rate, share * 2.0 * rate));
      }
      if (model.settings)
      {
        print(model, rate, "stiffest_stick_N_per_m", 0.0, stiffestStick(model, rate));
      }
    }
  }
}
} // namespace palpate::testing
