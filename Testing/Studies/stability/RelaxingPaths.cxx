// SPDX-License-Identifier: BSD-3-Clause
// Part e for a body that relaxes, with different curves and strengths from point to point: energy
// on closed paths and jumps of the force, by force form.
#include "Parts.h"
#include "RelaxingPlate.h"
#include "RelaxingModels.h"
#include "Renderings.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace palpate::testing
{
namespace
{
struct TimedLeg
{
  Vector3 to;   ///< mm
  double speed; ///< mm/s
};
struct TimedPath
{
  const char* name;
  Vector3 from;               ///< outside
  std::vector<TimedLeg> legs; ///< the last leg ends outside
};

/// A plate whose response varies: F = factor · δ^1.5 N to 1.5 mm, factors 0.5 to 1.5, strengths 0
/// to 2 and 0 to 1. The contact radius is 2 mm at 1 mm.
struct UnlikePlate
{
  UnlikePlate()
    : plate(
        1.5, series(), 1.5, [](const Vector3& at) { return 1.0 + 0.5 * std::sin(0.2 * at.x()); })
  {
    for (const Vector3& point : this->plate.surface.points)
    {
      this->strength.push_back(static_cast<float>(1.0 + std::sin(0.15 * point.y())));
      this->strength.push_back(static_cast<float>(0.5 + 0.5 * std::cos(0.15 * point.x())));
    }
    this->plate.terms.strength = this->strength.data();
    this->plate.terms.radius = 2.0;
  }
  static PronySeries series() { return relaxation({ { 1.0, 0.02 }, { 1.0, 0.3 } }); }

  RelaxingPlate plate;
  std::vector<float> strength;
};

std::vector<TimedPath> timedPaths()
{
  const auto at = [](double depth, double x, double y = 29.1) { return tipAt(depth, x, y); };
  std::vector<TimedPath> paths;
  paths.push_back(
    { "press", at(-0.2, 31.3), { { at(1.0, 31.3), 20.0 }, { at(-0.2, 31.3), 20.0 } } });
  // Material that has relaxed under a slow press is exchanged for unrelaxed material, and the tip
  // then unloads quickly.
  paths.push_back({ "slow in, slide, out", at(-0.2, 23.3),
    { { at(1.0, 23.3), 1.0 }, { at(1.0, 39.4), 20.0 }, { at(-0.2, 39.4), 20.0 },
      { at(-0.2, 23.3), 20.0 } } });
  paths.push_back({ "soft to stiff", at(-0.2, 23.6),
    { { at(1.0, 23.6), 20.0 }, { at(1.0, 7.9), 20.0 }, { at(-0.2, 7.9), 20.0 },
      { at(-0.2, 23.6), 20.0 } } });
  TimedPath sweeps{ "to and fro 2 mm", at(-0.2, 30.1), { { at(1.0, 30.1), 20.0 } } };
  TimedPath jumps{ "to and fro 1 µm", at(-0.2, 30.0005), { { at(1.0, 30.0005), 20.0 } } };
  for (int i = 0; i < 20; ++i)
  {
    sweeps.legs.push_back({ at(1.0, 32.1, 29.3), 20.0 });
    sweeps.legs.push_back({ at(1.0, 30.1), 20.0 });
  }
  // Four triangles meet at (30, 30): the two tips are on opposite sides of an edge.
  for (int i = 0; i < 2000; ++i)
  {
    jumps.legs.push_back({ at(1.0, 29.9995), 8.0 });
    jumps.legs.push_back({ at(1.0, 30.0005), 8.0 });
  }
  sweeps.legs.push_back({ at(-0.2, 30.1), 20.0 });
  jumps.legs.push_back({ at(-0.2, 30.0005), 20.0 });
  paths.push_back(sweeps);
  paths.push_back(jumps);
  std::mt19937 random(20260125);
  const auto share = [&random] { return (random() % 10000U + 0.5) / 10000.0; };
  TimedPath wandering{ "random", at(-0.2, 30.0, 30.0), {} };
  for (int i = 0; i < 40; ++i)
  {
    wandering.legs.push_back(
      { at(1.2 * share() - 0.2, 25.0 + 10.0 * share(), 25.0 + 10.0 * share()),
        2.0 * std::pow(50.0, share()) });
  }
  wandering.legs.push_back(
    { at(-0.2, wandering.legs.back().to.x(), wandering.legs.back().to.y()), 20.0 });
  wandering.legs.push_back({ wandering.from, 20.0 });
  paths.push_back(wandering);
  return paths;
}

/// Results of a tip that moves once along a path in steps of `step` mm.
struct TimedLap
{
  double jump = 0.0;  ///< largest |ΔF| of a step, divided by the force before the step
  double gain = 0.0;  ///< ∮F·dx, the energy gained by the hand, mJ
  double scale = 0.0; ///< ∮|F||dx|, mJ
};

TimedLap timedLap(
  const ContactBody& body, const ContactSettings& settings, const TimedPath& path, double step)
{
  ToolContact contact(body, settings);
  Contact last = contact.update(path.from, 0.0);
  Vector3 from = path.from;
  TimedLap found;
  for (const TimedLeg& leg : path.legs)
  {
    const Vector3 way = leg.to - from;
    const int steps = std::max(1, static_cast<int>(std::ceil(way.norm() / step)));
    for (int i = 1; i <= steps; ++i)
    {
      const Contact now = contact.update(from + way * i / steps, way.norm() / steps / leg.speed);
      found.gain += 0.5 * (last.force + now.force).dot(way) / steps;
      found.scale += 0.5 * (last.force.norm() + now.force.norm()) * way.norm() / steps;
      if (last.force.norm() > 0.1)
      {
        found.jump = std::max(found.jump, (now.force - last.force).norm() / last.force.norm());
      }
      last = now;
    }
    from = leg.to;
  }
  return found;
}

/// Energy (mJ) that a rigid hand gains, in addition to the damping of the device.
double generated(const std::shared_ptr<const ContactBody>& body, const ContactSettings& settings,
  const TimedPath& path, Control control)
{
  LoopSetting setting;
  setting.rate = 8000.0;
  setting.plant.mass = 0.01;
  setting.plant.damping = 1.5; // 2b/T is 24 N/mm: more than (1 + P) f' here
  setting.hand = { 1e9, 1e5 };
  SafetySettings safety = safetyOf(control, setting);
  safety.maximumForce = 1e6;
  double time = 0.0;
  Vector3 from = path.from;
  std::vector<WayPoint> way{ { 0.0, 1e-3 * from } };
  for (const TimedLeg& leg : path.legs)
  {
    time += (leg.to - from).norm() / leg.speed;
    way.push_back({ time, 1e-3 * leg.to });
    from = leg.to;
  }
  ServoRendering rendering(body, safety, settings);
  VirtualLoop loop(setting, way, rendering);
  loop.run(static_cast<int>(std::ceil(time * setting.rate)) + 2);
  return 1e3 * loop.audit().mostGenerated();
}
} // namespace

void relaxingPaths(bool isQuick)
{
  std::puts("path,form,elements,force_jump,loop_gain,gain_mJ,generated_mJ,generated_controlled_mJ");
  const UnlikePlate plate;
  const std::shared_ptr<const ContactBody> body = plate.plate.body();
  const std::pair<ForceForm, const char*> forms[] = { { ForceForm::EnergyConsistent,
                                                        "EnergyConsistent" },
    { ForceForm::NormalizedDirection, "NormalizedDirection" } };
  for (const TimedPath& path : timedPaths())
  {
    for (const auto& [form, name] : forms)
    {
      for (const int elements : AllElements)
      {
        ContactSettings settings = withElements(elements);
        settings.form = form;
        const TimedLap found = timedLap(*body, settings, path, isQuick ? 5e-3 : 1e-3);
        std::printf("%s,%s,%d,%.4g,%.4g,%.4g,%.4g,%.4g\n",
          ("\"" + std::string(path.name) + "\"").c_str(), name, elements, found.jump,
          found.gain / found.scale, found.gain, generated(body, settings, path, Control::None),
          generated(body, settings, path, Control::Passivity));
        std::fflush(stdout);
      }
    }
  }
}
} // namespace palpate::testing
