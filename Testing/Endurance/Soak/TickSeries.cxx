// SPDX-License-Identifier: BSD-3-Clause
#include "TickSeries.h"

#include "Haptics/Servo/ServoStep.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace palpate::endurance
{
namespace
{
/// Returns the height of the tip over the body, mm. The tip moves in and out three times. It is
/// inside at all times that the header names.
double height(double time)
{
  struct Knot
  {
    double time;
    double height;
  };
  constexpr std::array<Knot, 10> knots = { { { 0.0, 1.5 }, { 0.2, 1.0 }, { 0.35, -2.0 },
    { 1.0, -1.5 }, { 1.1, 1.0 }, { 1.25, -2.0 }, { 1.5, -1.5 }, { 1.58, 0.8 }, { 1.68, -2.0 },
    { 2.0, -1.0 } } };
  std::size_t next = 1;
  while (next + 1 < knots.size() && knots[next].time < time)
  {
    ++next;
  }
  const Knot& from = knots[next - 1];
  const Knot& to = knots[next];
  const double way = (time - from.time) / (to.time - from.time);
  return from.height + way * (to.height - from.height) + 0.2 * std::sin(40.0 * time);
}

DeviceSample sampleAt(std::size_t tick, const Vector3& centre, bool withLosses)
{
  const double time = static_cast<double>(tick) / TickSeries::Rate;
  const Vector3 direction(std::cos(0.8 * time), std::sin(0.8 * time), 0.2 * std::sin(5.0 * time));
  DeviceSample sample;
  sample.position = TickSeries::frame().position(
    centre + (SceneSupply::Radius + height(time)) * direction.normalized());
  sample.valid = true;
  if (!withLosses)
  {
    return sample;
  }
  sample.valid = !(tick >= TickSeries::Absent && tick < TickSeries::Absent + TickSeries::Gap);
  if (tick == TickSeries::Broken)
  {
    sample.position.y() = std::numeric_limits<double>::quiet_NaN();
  }
  if (tick > TickSeries::Silent && tick <= TickSeries::Silent + TickSeries::Gap)
  {
    sample = sampleAt(TickSeries::Silent, centre, true);
    sample.fresh = false;
  }
  return sample;
}

std::unique_ptr<ServoScene> servoScene(const SuppliedScene& supplied)
{
  ContactSettings settings;
  settings.friction.coefficient = supplied.felt.friction;
  settings.relaxationElements = supplied.felt.elements;
  return std::make_unique<ServoScene>(supplied.kernel, settings);
}
} // namespace

DeviceFrame TickSeries::frame()
{
  DeviceFrame made;
  made.axes = Eigen::AngleAxisd(1.1, Vector3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  made.origin = Vector3(-4.0, 7.0, 1.0);
  made.scale = 0.8;
  return made;
}

WorkspaceMapping TickSeries::mapping()
{
  return { frame().axes, frame().origin, frame().scale };
}

SafetySettings TickSeries::safety()
{
  return SafetySettings::of(specificationOf(DeviceLimits{}, Rate));
}

TickSeries::TickSeries(unsigned seed, bool swaps, double friction, double begin, Supplied bodies)
  : Supply(seed, bodies)
  , First(this->Supply.make())
  , Second(this->Supply.make())
{
  if (friction >= 0.0)
  {
    this->First.felt.friction = friction;
    this->Second.felt.friction = friction;
  }
  ServoStep step(servoScene(this->First), mapping(), safety());
  for (std::size_t i = 0; i < Length; ++i)
  {
    if (swaps && i == Swap)
    {
      step.change(servoScene(this->Second));
    }
    const double time = begin + static_cast<double>(i) / Rate;
    const DeviceSample sample =
      sampleAt(i, this->Supply.centre(), swaps || bodies != Supplied::Relaxing);
    const Tick made = step.step(sample, time);
    this->ticks.push_back(factsOf(time, sample, made.deviceForce, made));
  }
}

bool TickSeries::moves(std::size_t tick) const
{
  return tick > 0 && !this->ticks[tick].isPassivityLimited &&
    (this->ticks[tick].sent - this->ticks[tick - 1].sent).norm() > 5e-4 &&
    this->ticks[tick].sent.norm() > 0.01 && this->ticks[tick - 1].sent.norm() > 0.01;
}

TickSeries::Finding TickSeries::firstFault() const
{
  TickChecker checker(frame(), DeviceLimits{}, this->First.felt);
  for (std::size_t i = 0; i < this->ticks.size(); ++i)
  {
    if (i == Swap)
    {
      checker.offer(this->Second.felt);
    }
    if (TickVerdict verdict = checker.check(this->ticks[i]))
    {
      return { verdict.fault, i, std::move(verdict.text) };
    }
  }
  return {};
}

TickTally TickSeries::tally() const
{
  TickChecker checker(frame(), DeviceLimits{}, this->First.felt);
  checker.offer(this->Second.felt);
  for (const TickFacts& tick : this->ticks)
  {
    checker.check(tick);
  }
  return checker.tally();
}
} // namespace palpate::endurance
