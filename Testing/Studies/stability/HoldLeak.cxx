// SPDX-License-Identifier: BSD-3-Clause
// Part c: the energy gained from the hold by a press and release, compared with F_max v (T + 2
// t_d).
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
constexpr double Deepest = 2e-3; // m

/// A rigid hand moves the device down at `speed` and up again.
void press(const ResponseModel& model, double rate, double speed, double delay, Control control)
{
  LoopSetting setting;
  setting.rate = rate;
  setting.plant.mass = 0.01;
  setting.plant.forceDelay = delay / rate;
  setting.hand = { 1e9, 1e5 }; // follows within nanometres, without delay
  ServoRendering rendering(plateOf(model), safetyOf(control, setting));
  const double time = 2.0 * Deepest / speed;
  VirtualLoop loop(setting,
    { { 0.0, { 0, 0, Deepest } }, { time, { 0, 0, -Deepest } }, { 2.0 * time, { 0, 0, Deepest } } },
    rendering);
  loop.run(static_cast<int>(std::ceil(2.0 * time * rate)) + 4);
  std::printf("%s,%g,%g,%g,%s,%.6g,%.6g,%.6g\n", model.name.c_str(), rate, speed, delay,
    nameOf(control), loop.peakForce(), 1e3 * loop.audit().work(),
    1e3 * loop.audit().mostGenerated());
}
} // namespace

void holdLeak(bool isQuick)
{
  std::puts("model,rate_Hz,speed_m_s,delay_ticks,control,peak_force_N,leaked_mJ,generated_mJ");
  std::vector<ResponseModel> models = allModels(0.5, 1e9);
  for (const ResponseModel& model : models)
  {
    for (const double rate : { 1000.0, 4000.0 })
    {
      // At 20 and 100 mm/s the motion turns at a tick, otherwise between two ticks.
      for (const double speed : { 0.02, 0.03, 0.1, 0.3 })
      {
        for (const double delay : { 0.0, 1.0 })
        {
          for (const Control control : { Control::None, Control::Passivity, Control::Chain })
          {
            if (!isQuick || (rate == 1000.0 && control != Control::Passivity && speed != 0.02))
            {
              press(model, rate, speed, delay, control);
            }
          }
        }
      }
    }
  }
}
} // namespace palpate::testing
