// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_Restlessness_h
#define palpate_testing_Restlessness_h

#include "VirtualLoop.h"

#include <algorithm>

namespace palpate::testing
{
/// Result of a press.
struct Course
{
  bool rests = false;     ///< the motion decays
  double speed = 0.0;     ///< largest in the end, m/s
  double peakForce = 0.0; ///< N, of the motor
  double generated =
    0.0; ///< largest energy gained at any time, in addition to the device's damping, J
};

/// A speed that a hand cannot feel, m/s: at the 100 Hz and more of a buzz it is 0.2 µm.
constexpr double StillSpeed = 1e-4;

inline Course courseOf(const VirtualLoop& loop, bool rests, double speed)
{
  return { rests, speed, loop.peakForce(), loop.audit().mostGenerated() };
}

/// Checks that a small swing decays. The motion is watched for two times LoopSetting::watchedTicks.
/// In the last quarter its speed must be 1 % less than in the quarter before half time, which is
/// the decay at a stiffness 0.05 % below the limit. The speed must also stay below `most` (m/s):
/// above this speed the motion is an oscillation that has stopped growing.
inline Course smallSwing(VirtualLoop& loop, int ticks, double most)
{
  const int window = ticks / 2;
  const double first = loop.peakSpeed(window);
  const double before = loop.peakSpeed(window);
  loop.run(ticks - window);
  const double last = loop.peakSpeed(window);
  return courseOf(loop, last < 0.99 * before && std::max(first, before) < most, last);
}

/// Checks that any motion decays: in the last of six times LoopSetting::watchedTicks (24 s at 0.1
/// kg and 1 N s/m) the speed is below StillSpeed.
inline Course anyMotion(VirtualLoop& loop, int ticks)
{
  loop.run(5 * ticks);
  const double last = loop.peakSpeed(ticks);
  return courseOf(loop, last < StillSpeed, last);
}
} // namespace palpate::testing

#endif
