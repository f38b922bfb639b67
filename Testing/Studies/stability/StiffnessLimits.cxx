// SPDX-License-Identifier: BSD-3-Clause
// Part a: the largest stable stiffness of a plate with a linear response, by bisection.
#include "LoopPoles.h"
#include "Parts.h"
#include "Renderings.h"
#include "ResponseModels.h"

#include <cmath>
#include <cstdio>
#include <vector>

namespace palpate::testing
{
namespace
{
constexpr double LightPush = 1.0; // N

/// A mass at its rest depth on the plate under its push, disturbed by a tenth of the depth. The
/// target of the hand, if there is a hand, is the rest position.
VirtualLoop disturbed(const LoopSetting& setting, double stiffness, Rendering& plate)
{
  const double depth = setting.push / stiffness;
  return VirtualLoop(
    setting, { { 0.0, { 0.0, 0.0, -1.1 * depth } }, { 1e-12, { 0.0, 0.0, -depth } } }, plate);
}

ServoRendering plateOfStiffness(double stiffness)
{
  // The range is twice the rest depth. Beyond it the curve continues along its tangent.
  const double range = 2e3 * LightPush / stiffness;
  return { plateOf(linearModel("linear", 1e-3 * stiffness, range)),
    safetyOf(Control::None, LoopSetting()) };
}

bool isStable(const LoopSetting& setting, double stiffness)
{
  const double delay = setting.plant.forceDelay * setting.rate;
  const int order = 2 + static_cast<int>(std::ceil(delay - 1e-9));
  ServoRendering plate = plateOfStiffness(stiffness);
  VirtualLoop loop = disturbed(setting, stiffness, plate);
  loop.run(order - 2); // until the first forces have arrived
  return largestPole(loop.heights(2 * order + 4), order) < 1.0;
}

double largestStiffness(const LoopSetting& setting)
{
  double low = 0.05 * setting.passiveStiffness();
  double high = 20.0 * (setting.plant.damping + setting.hand.damping) * setting.rate;
  for (int i = 0; i < 40; ++i)
  {
    const double middle = std::sqrt(low * high);
    (isStable(setting, middle) ? low : high) = middle;
  }
  return low;
}

/// Ratio of the later swing to the first.
double growth(const LoopSetting& setting, double stiffness)
{
  ServoRendering plate = plateOfStiffness(stiffness);
  VirtualLoop loop = disturbed(setting, stiffness, plate);
  const int watched = setting.watchedTicks();
  const int window = watched / 4;
  loop.run(window);
  const double first = loop.swing(window);
  loop.run(watched);
  return loop.swing(window) / first;
}

void print(const LoopSetting& setting, bool isWatched)
{
  const double limit = largestStiffness(setting);
  const double below = isWatched ? growth(setting, 0.99 * limit) : 0.0;
  const double above = isWatched ? growth(setting, 1.01 * limit) : 0.0;
  std::printf("%g,%g,%g,%g,%g,%g,%.8g,%.5g,%.5g\n", setting.rate, setting.plant.mass,
    setting.plant.damping, setting.plant.forceDelay * setting.rate, setting.hand.stiffness,
    setting.hand.damping, limit, below, above);
  std::fflush(stdout);
}
} // namespace

void stiffnessLimits(bool isQuick)
{
  std::puts("rate_Hz,mass_kg,damping_Ns_per_m,delay_ticks,hand_N_per_m,hand_Ns_per_m,limit_N_per_m,"
            "growth_below,growth_above");
  const std::vector<double> rates = isQuick ? std::vector<double>{ 1000, 4000 }
                                            : std::vector<double>{ 500, 1000, 2000, 4000, 8000 };
  const std::vector<double> dampings =
    isQuick ? std::vector<double>{ 1.0 } : std::vector<double>{ 0.5, 1.0, 2.0, 5.0 };
  const HandModel hands[] = { Nobody, { 300.0, 0.0 }, { 300.0, 5.0 }, { 1000.0, 10.0 } };
  for (const double rate : rates)
  {
    for (const double damping : dampings)
    {
      for (const double delay : { 0.0, 0.5, 1.0, 2.0 })
      {
        LoopSetting setting;
        setting.rate = rate;
        setting.push = LightPush;
        setting.plant.damping = damping;
        setting.plant.forceDelay = delay / rate;
        for (const HandModel& hand : hands)
        {
          if (&hand == hands || (!isQuick && damping == 1.0 && (delay == 0.0 || delay == 1.0)))
          {
            setting.hand = hand;
            print(setting, !isQuick);
          }
        }
      }
    }
  }
}
} // namespace palpate::testing
