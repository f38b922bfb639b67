// SPDX-License-Identifier: BSD-3-Clause
// Part b: each response model is pressed by a growing force until the loop oscillates, without
// control and with each control.
#include "Parts.h"
#include "Renderings.h"
#include "ResponseModels.h"
#include "RestingDepth.h"
#include "Restlessness.h"

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace palpate::testing
{
namespace
{
constexpr double LeastPush = 1e-3; // N

enum class Start
{
  Held,   ///< at rest, a thousandth of the depth from the rest depth
  Dropped ///< released 1 mm above the surface
};

/// Motion of the device under this push. `probe`: a second rendering of the same body.
Course pressed(
  const LoopSetting& base, Rendering& rendering, Rendering& probe, double push, Start start)
{
  LoopSetting setting = base;
  setting.push = push;
  if (start == Start::Dropped)
  {
    VirtualLoop loop(setting, { { 0.0, { 0.0, 0.0, 1e-3 } } }, rendering);
    return anyMotion(loop, setting.watchedTicks());
  }
  const double depth = restingDepth(probe, push);
  const double stiffness = stiffnessAt(probe, depth);
  VirtualLoop loop(setting, { { 0.0, { 0.0, 0.0, -1.001 * depth } } }, rendering);
  return smallSwing(
    loop, setting.watchedTicks(), 0.1 * depth * std::sqrt(stiffness / setting.plant.mass));
}

/// The largest stable push (N), up to StrongestPush, and the motion under this push; if no push is
/// stable, the motion under the strongest push. Without `isSought` only the strongest push is
/// tried: `force` is 0 if it is unstable.
struct ForceLimit
{
  double force = 0.0;
  Course strongest;
};

template <class Render>
ForceLimit largestPush(const LoopSetting& setting, Start start, bool isSought, const Render& render)
{
  const auto course = [&](double push)
  {
    auto rendering = render();
    auto probe = render();
    return pressed(setting, *rendering, *probe, push, start);
  };
  ForceLimit limit;
  limit.strongest = course(StrongestPush);
  limit.force = limit.strongest.rests ? StrongestPush : 0.0;
  if (limit.force > 0.0 || !isSought || !course(LeastPush).rests)
  {
    return limit;
  }
  double low = LeastPush;
  double high = StrongestPush;
  for (int i = 0; i < (start == Start::Held ? 14 : 10); ++i)
  {
    const double middle = std::sqrt(low * high);
    (course(middle).rests ? low : high) = middle;
  }
  limit.force = low;
  return limit;
}

void print(const LoopSetting& setting, const ResponseModel& model, double modulus,
  const char* evaluated, const char* control, Start start, const ForceLimit& limit)
{
  const double depth = model.depthOf(limit.force);
  std::printf("%s,%g,%g,%g,%s,%s,%s,%.5g,%.5g,%.5g,%.4g,%.4g,%.4g\n", model.name.c_str(), modulus,
    setting.rate, setting.plant.damping, evaluated, control,
    start == Start::Held ? "held" : "dropped", limit.force, limit.force > 0.0 ? depth : 0.0,
    1e3 * model.law(limit.force > 0.0 ? depth : 1e-9).stiffness, limit.strongest.peakForce,
    1e3 * limit.strongest.speed, 1e3 * limit.strongest.generated);
  std::fflush(stdout);
}

void pressAll(const LoopSetting& setting, const ResponseModel& model, double modulus)
{
  const auto body = plateOf(model);
  const auto bare = [&]
  { return std::make_unique<BareLaw>([&](double depth) { return model.law(depth).force; }); };
  // The law of a layer takes 20 µs to evaluate, too slow here; its stored form is fast.
  if (model.name != "layer")
  {
    print(setting, model, modulus, "law", "none", Start::Held,
      largestPush(setting, Start::Held, true, bare));
  }
  const auto stored = [&](Control control)
  {
    return [&, control]
    { return std::make_unique<ServoRendering>(body, safetyOf(control, setting)); };
  };
  print(setting, model, modulus, "stored", "none", Start::Held,
    largestPush(setting, Start::Held, true, stored(Control::None)));
  for (const Control control : AllControls)
  {
    print(setting, model, modulus, "stored", nameOf(control), Start::Dropped,
      largestPush(setting, Start::Dropped, control == Control::None, stored(control)));
  }
}
} // namespace

void pressedUntilItBuzzes(bool isQuick)
{
  std::puts("model,modulus_MPa,rate_Hz,damping_Ns_per_m,evaluated,control,start,limit_N,depth_mm,"
            "stiffness_N_per_m,"
            "peak_force_N,last_speed_mm_s,generated_mJ");
  for (const double rate : { 1000.0, 4000.0 })
  {
    for (const double modulus :
      { 3.45, 1.0, 0.1 }) // the paper's rubber, stiff tissue and soft tissue
    {
      if (isQuick && (rate != 1000.0 || modulus != 1.0))
      {
        continue;
      }
      for (const ResponseModel& model : allModels(modulus, 1.5 * StrongestPush))
      {
        if (isQuick && model.name != "sphere:6.35" && model.name != "flat:1.6" &&
          model.name != "spring")
        {
          continue;
        }
        LoopSetting setting;
        setting.rate = rate;
        setting.hand = Nobody;
        pressAll(setting, model, modulus);
      }
    }
  }
}
} // namespace palpate::testing
