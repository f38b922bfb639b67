// SPDX-License-Identifier: BSD-3-Clause
// Part a: the effect of an encoder's step. A spring on rounded readings never comes to rest without
// Coulomb friction, which must stop the last swing.
#include "Parts.h"
#include "Renderings.h"
#include "ResponseModels.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace palpate::testing
{
namespace
{
/// The remaining swing in the last half second: the worst of several pushes. One push allows rest
/// at a whole step of the encoder, another one is exactly between two steps.
struct Rest
{
  double swing = 0.0; ///< m
  double speed = 0.0; ///< m/s
};

Rest restOf(const LoopSetting& setting, double stiffness, int pushes)
{
  Rest worst;
  const auto body = plateOf(linearModel("linear", 1e-3 * stiffness, 2e3 / stiffness));
  for (int i = 0; i < pushes; ++i)
  {
    const double step = stiffness * setting.plant.encoderStep; // N
    const double force = step * (std::ceil(0.5 / step) + static_cast<double>(i) / pushes);
    ServoRendering plate(body, safetyOf(Control::None, setting));
    LoopSetting pushed = setting;
    pushed.push = force;
    VirtualLoop loop(pushed, { { 0.0, { 0.0, 0.0, -0.9 * force / stiffness } } }, plate);
    loop.run(static_cast<int>(2.5 * setting.rate));
    const std::vector<double> heights = loop.heights(static_cast<int>(0.5 * setting.rate));
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    worst.swing = std::max(worst.swing, *high - *low);
    for (std::size_t k = 1; k < heights.size(); ++k)
    {
      worst.speed = std::max(worst.speed, std::abs(heights[k] - heights[k - 1]) * setting.rate);
    }
  }
  return worst;
}

bool rests(const LoopSetting& setting, double stiffness)
{
  return restOf(setting, stiffness, 4).speed < 1e-6;
}

/// The largest stiffness at which the motion comes to rest. All smaller stiffnesses on a ladder of
/// 25 % steps must come to rest too; the search ends at ten times the passive stiffness.
double largestRestful(const LoopSetting& setting)
{
  double high = 20.0;
  while (high < 10.0 * setting.passiveStiffness() && rests(setting, high))
  {
    high *= 1.25;
  }
  double low = high / 1.25;
  if (high >= 10.0 * setting.passiveStiffness())
  {
    return low;
  }
  for (int i = 0; i < 9; ++i)
  {
    const double middle = std::sqrt(low * high);
    (rests(setting, middle) ? low : high) = middle;
  }
  return low;
}
} // namespace

void encoderLimits(bool isQuick)
{
  std::puts(
    "rate_Hz,damping_Ns_per_m,encoder_um,coulomb_N,restful_N_per_m,half_swing_um,half_speed_mm_s");
  for (const double rate : { 1000.0, 4000.0 })
  {
    for (const double step : { 1e-6, 10e-6, 50e-6 })
    {
      for (const double friction : { 0.0, 0.02, 0.1 })
      {
        if (isQuick && (rate != 1000.0 || step != 10e-6 || friction == 0.1))
        {
          continue;
        }
        LoopSetting setting;
        setting.rate = rate;
        setting.hand = Nobody;
        setting.plant.encoderStep = step;
        setting.plant.friction = friction;
        const Rest half = restOf(setting, 0.5 * setting.passiveStiffness(), 4);
        std::printf("%g,%g,%g,%g,%.5g,%.5g,%.5g\n", rate, setting.plant.damping, 1e6 * step,
          friction, friction > 0.0 ? largestRestful(setting) : 0.0, 1e6 * half.swing,
          1e3 * half.speed);
        std::fflush(stdout);
      }
    }
  }
}
} // namespace palpate::testing
