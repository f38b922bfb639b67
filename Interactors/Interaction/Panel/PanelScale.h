// SPDX-License-Identifier: BSD-3-Clause
#ifndef PanelScale_h
#define PanelScale_h

#include <algorithm>
#include <cmath>

namespace palpate
{
/// The value of a quantity over the position along a slider: 0 at its left end, 1 at its right.
struct PanelScale
{
  double low = 0.0;
  double high = 1.0;
  bool isLogarithmic = false; ///< low > 0 then
  double step = 0.01;         ///< of the values; of a logarithmic scale, relative

  double shareOf(double value) const
  {
    const double share = this->isLogarithmic
      ? std::log(std::max(value, this->low) / this->low) / std::log(this->high / this->low)
      : (value - this->low) / (this->high - this->low);
    return std::clamp(share, 0.0, 1.0);
  }

  /// Rounded to a whole number of steps.
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
