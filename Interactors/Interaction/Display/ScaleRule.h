// SPDX-License-Identifier: BSD-3-Clause
#ifndef ScaleRule_h
#define ScaleRule_h

#include <cmath>
#include <limits>

namespace palpate
{
/// Decides when the end of a scale changes. Arrows, colours and the axes of charts use this rule. A
/// scale grows immediately if a drawn value exceeds its end. It shrinks if for the time Seconds all
/// drawn values have been below the fraction Share of its end.
class ScaleRule
{
public:
  static constexpr double Share = 1.0 / 3.0;
  static constexpr double Seconds = 3.0;

  /// Whether a scale that ends at `end` must be adapted to `largest`, the largest value drawn at
  /// `time` (s). The scale does not shrink if `largest` is not positive or `time` is not finite.
  bool mustChange(double largest, double end, double time)
  {
    constexpr double never = std::numeric_limits<double>::quiet_NaN();
    if (largest > end && std::isfinite(largest))
    {
      this->SmallSince = never;
      return true;
    }
    if (!(largest > 0.0 && largest < Share * end) || !std::isfinite(time))
    {
      this->SmallSince = never;
      return false;
    }
    if (!(this->SmallSince <= time)) // also true if the time has decreased
    {
      this->SmallSince = time;
    }
    const bool isLong = time - this->SmallSince >= Seconds;
    this->SmallSince = isLong ? never : this->SmallSince;
    return isLong;
  }

private:
  /// Time since which the values have been small, s. NaN if they are not small.
  double SmallSince = std::numeric_limits<double>::quiet_NaN();
};
} // namespace palpate

#endif
