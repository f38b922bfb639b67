// SPDX-License-Identifier: BSD-3-Clause
#ifndef PanelScale_h
#define PanelScale_h

#include <algorithm>
#include <cmath>

namespace palpate
{
/// Converts between the value of a quantity and the position on a slider, from 0 (left end) to 1
/// (right end).
struct PanelScale
{
  double low = 0.0;
  double high = 1.0;
  bool isLogarithmic = false; ///< requires low > 0
  double step = 0.01;         ///< step between values; relative for a logarithmic scale

  double shareOf(double value) const
  {
    const double share = this->isLogarithmic
      ? std::log(std::max(value, this->low) / this->low) / std::log(this->high / this->low)
      : (value - this->low) / (this->high - this->low);
    return std::clamp(share, 0.0, 1.0);
  }

  /// Returns the value at a position, rounded to a whole number of steps.
  double valueAt(double share) const
  {
    const double within = std::clamp(share, 0.0, 1.0);
    if (!this->isLogarithmic)
    {
      const double value = this->low + within * (this->high - this->low);
      return std::clamp(this->step * std::round(value / this->step), this->low, this->high);
    }
    const double value = this->low * std::pow(this->high / this->low, within);
    const double unit = this->step * std::pow(10.0, std::floor(std::log10(value)));
    return std::clamp(unit * std::round(value / unit), this->low, this->high);
  }
};
} // namespace palpate

#endif
