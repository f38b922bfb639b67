// SPDX-License-Identifier: BSD-3-Clause
// Part f: devices that fail, with every rendering. A relaxed hand kneads soft tissue with the 6.35
// mm sphere while the device drops readings, delivers them late, reports NaN, hangs, or is
// unplugged.
#include "Parts.h"
#include "Renderings.h"
#include "ResponseModels.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace palpate::testing
{
namespace
{
constexpr double Modulus = 0.3;    // MPa
constexpr double FaultBegin = 1.7; // s; on the way up
constexpr double FaultEnd = 4.5;
constexpr double End = 7.0;

struct Failure
{
  const char* name;
  DeviceFaults faults;
  double delay = 0.0;  ///< s, of the force, permanently
  double stated = 0.0; ///< s: the bound of its delay that the device states
  double stall = 0.0;  ///< s, of the host
};

ScheduledFault at(DeviceFault fault, double start, double duration)
{
  ScheduledFault scheduled;
  scheduled.fault = fault;
  scheduled.start = start;
  scheduled.duration = duration;
  return scheduled;
}

/// A fault at random readings (from a separate splitmix64) during the faulty period.
DeviceFaults sprinkled(DeviceFault fault, double share, double duration, double rate)
{
  DeviceFaults faults;
  std::uint64_t state = 20021;
  for (double time = FaultBegin; time < FaultEnd; time += 1.0 / rate)
  {
    state = state * 6364136223846793005U + 1442695040888963407U;
    if (static_cast<double>(state >> 11U) * 0x1p-53 < share)
    {
      faults.schedule.push_back(at(fault, time, duration));
    }
  }
  return faults;
}

DeviceFaults once(DeviceFault fault, double duration)
{
  DeviceFaults faults;
  faults.schedule = { at(fault, FaultBegin, duration) };
  return faults;
}

std::vector<Failure> allFailures(double rate)
{
  return { { "none", {} }, { "dropped", sprinkled(DeviceFault::Dropped, 0.2, 0.0, rate) },
    { "late", sprinkled(DeviceFault::Late, 0.05, 5e-3, rate), 0.0, 5e-3 },
    { "nan", sprinkled(DeviceFault::NotANumber, 0.02, 0.0, rate) },
    { "stall", once(DeviceFault::Stall, 0.1) }, { "host", {}, 0.0, 0.0, 0.1 },
    { "unplug", once(DeviceFault::Disconnect, 0.3) }, { "delay", {}, 1e-3, 1e-3 } };
}

/// A hand whose target goes up and down once a second, from 1 mm above the surface to a depth of 7
/// mm; outside at the end.
std::vector<WayPoint> kneading()
{
  std::vector<WayPoint> path{ { 0.0, { 0.0, 0.0, 4e-3 } } };
  for (int i = 50; i <= 600; ++i)
  {
    const double time = 0.01 * i;
    path.push_back({ time, { 0.0, 0.0, -3e-3 + 4e-3 * std::cos(6.283185307179586 * time) } });
  }
  path.push_back({ 6.2, { 0.0, 0.0, 4e-3 } });
  return path;
}

struct Outcome
{
  double peakForce = 0.0; ///< N
  double peakSpeed = 0.0; ///< m/s
  double numb = 0.0;      ///< share of the readings deep inside with zero motor force
  double lastSpeed = 0.0; ///< m/s, in the last tenth of a second, outside
  double generated = 0.0; ///< J
  int notFinite = 0;      ///< wanted forces that are not finite
};

Outcome course(const LoopSetting& setting, Rendering& rendering, const DeviceFaults& faults)
{
  VirtualLoop loop(setting, kneading(), rendering, faults);
  Outcome outcome;
  int deep = 0;
  int numb = 0;
  const int ticks = static_cast<int>(End * setting.rate);
  for (int i = 0; i < ticks; ++i)
  {
    loop.tick();
    const double speed = loop.velocity().norm();
    outcome.peakSpeed = std::max(outcome.peakSpeed, speed);
    outcome.lastSpeed = i < ticks - setting.rate / 10 ? 0.0 : std::max(outcome.lastSpeed, speed);
    const bool isDeep = loop.position().z() < -0.2e-3;
    deep += isDeep;
    numb += isDeep && loop.acting().norm() == 0.0;
  }
  outcome.peakForce = loop.peakForce();
  outcome.numb = deep > 0 ? static_cast<double>(numb) / deep : 0.0;
  outcome.generated = loop.audit().mostGenerated();
  outcome.notFinite = loop.notFinite();
  return outcome;
}

struct Method
{
  std::string name;
  std::unique_ptr<Rendering> rendering;
};

std::vector<Method> allMethods(const LoopSetting& setting)
{
  const ResponseModel sphere = toolModel("sphere:6.35", Modulus, 10.0);
  const double secant = sphere.law(1.0).force;
  std::vector<Method> methods;
  methods.push_back({ "point spring",
    std::make_unique<BareLaw>([secant](double depth) { return secant * depth; }) });
  methods.push_back({ "law at run time",
    std::make_unique<BareLaw>([sphere](double depth) { return sphere.law(depth).force; }) });
  const auto body = plateOf(sphere);
  for (const Control control : AllControls)
  {
    methods.push_back({ std::string("stored, ") + nameOf(control),
      std::make_unique<ServoRendering>(body, safetyOf(control, setting)) });
  }
  return methods;
}
} // namespace

void deviceFailures(bool isQuick)
{
  std::puts("method,failure,rate_Hz,peak_force_N,peak_speed_mm_s,numb_share,last_speed_mm_s,"
            "generated_mJ,not_finite");
  for (const double rate : { 1000.0, 4000.0 })
  {
    if (isQuick && rate != 1000.0)
    {
      continue;
    }
    for (const Failure& failure : allFailures(rate))
    {
      LoopSetting setting;
      setting.rate = rate;
      setting.plant.forceDelay = failure.delay;
      setting.statedDelay = failure.stated;
      setting.hostStalls = FaultBegin;
      setting.hostGoesOn = FaultBegin + failure.stall;
      for (Method& method : allMethods(setting))
      {
        const Outcome outcome = course(setting, *method.rendering, failure.faults);
        std::printf("\"%s\",%s,%g,%.5g,%.5g,%.4g,%.4g,%.4g,%d\n", method.name.c_str(), failure.name,
          rate, outcome.peakForce, 1e3 * outcome.peakSpeed, outcome.numb, 1e3 * outcome.lastSpeed,
          1e3 * outcome.generated, outcome.notFinite);
      }
    }
  }
}
} // namespace palpate::testing
