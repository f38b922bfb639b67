// SPDX-License-Identifier: BSD-3-Clause
#ifndef ScaleRule_h
#define ScaleRule_h

#include <cmath>
#include <limits>

namespace palpate
{
/// When the end of a scale changes: one rule for arrows, colours and the axes of charts. A scale
/// grows at once if a drawn value exceeds its end. It shrinks if for Seconds all drawn values have
/// been below Share of its end.
class ScaleRule
{
public:
  static constexpr double Share = 1.0 / 3.0;
  static constexpr double Seconds = 3.0;

  /// Whether a scale that ends at `end` must be fitted to `largest`, the largest value that is
  /// drawn at `time` (s). It does not shrink if `largest` is not positive or `time` not finite.
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
    if (!(this->SmallSince <= time)) // also after a restart of the time
    {
      this->SmallSince = time;
    }
    const bool isLong = time - this->SmallSince >= Seconds;
    this->SmallSince = isLong ? never : this->SmallSince;
    return isLong;
  }

private:
  double SmallSince = std::numeric_limits<double>::quiet_NaN(); ///< s; NaN: not small
};
} // namespace palpate

#endif
