// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ForceRamp_h
#define palpate_ForceRamp_h

#include <algorithm>

namespace palpate
{
/**
 * A share of a force that moves between 0 and 1 without a step: straight in time, the whole way in
 * 50 ms.
 *
 * Straight, because of all ways that take 50 ms it has the least greatest rate (a smooth step has
 * 1.5 times that); so a force of share s(t) F changes per tick of length T by no more than its
 * motion makes F change and |F| T / 50 ms. A late tick counts for no more than MaximumStep, so that
 * a stall makes the ramp longer and not the step larger.
 */
class ForceRamp
{
public:
  static constexpr double Duration = 0.05;   ///< s
  static constexpr double MaximumStep = 0.1; ///< of the way, per tick: 5 ms

  explicit ForceRamp(double share) noexcept
    : Share(share)
  {
  }

  /// `elapsed` (s) >= 0 towards `target`, 0 to 1; returns the new share.
  double advance(double target, double elapsed) noexcept
  {
    const double step = std::min(elapsed / Duration, MaximumStep);
    this->Share += std::clamp(target - this->Share, -step, step);
    return this->Share;
  }
  double share() const noexcept { return this->Share; }

private:
  double Share;
};
} // namespace palpate

#endif
