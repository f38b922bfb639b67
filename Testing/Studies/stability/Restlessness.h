// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_Restlessness_h
#define palpate_testing_Restlessness_h

#include "VirtualLoop.h"

#include <algorithm>

namespace palpate::testing
{
/// What became of a press.
struct Course
{
  bool rests = false;     ///< the motion dies down
  double speed = 0.0;     ///< largest in the end, m/s
  double peakForce = 0.0; ///< N, of the motor
  double generated = 0.0; ///< most energy got out at any time, beyond what the device damps, J
};

/// A speed that no hand feels, m/s: at the 100 Hz and more of a buzz 0.2 µm.
constexpr double StillSpeed = 1e-4;

inline Course courseOf(const VirtualLoop& loop, bool rests, double speed)
{
  return { rests, speed, loop.peakForce(), loop.audit().mostGenerated() };
}

/// Whether a small swing dies: in the last quarter of two times LoopSetting::watchedTicks its speed
/// is 1 % less than in the quarter before half time, as a stiffness 0.05 % below its limit makes
/// it; and it never was above `most` (m/s), where it is no small swing any more but a buzz that has
/// stopped growing.
inline Course smallSwing(VirtualLoop& loop, int ticks, double most)
{
  const int window = ticks / 2;
  const double first = loop.peakSpeed(window);
  const double before = loop.peakSpeed(window);
  loop.run(ticks - window);
  const double last = loop.peakSpeed(window);
  return courseOf(loop, last < 0.99 * before && std::max(first, before) < most, last);
}

/// Whether any motion dies down: no hand feels it any more in the last of six times
/// LoopSetting::watchedTicks (24 s at 0.1 kg and 1 N s/m).
inline Course anyMotion(VirtualLoop& loop, int ticks)
{
  loop.run(5 * ticks);
  const double last = loop.peakSpeed(ticks);
  return courseOf(loop, last < StillSpeed, last);
}
} // namespace palpate::testing

#endif
