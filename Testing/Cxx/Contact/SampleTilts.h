// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_SampleTilts_h
#define palpate_testing_SampleTilts_h

#include "Contact/Tilt/TiltViews.h"

#include <cmath>
#include <functional>
#include <vector>

namespace palpate::testing
{
/// The numbers of a TiltTable made from functions. This object owns them.
struct TiltStore
{
  using Factor = std::function<double(double depth, double angle)>;
  using Drop = std::function<double(double angle)>;

  /// A table for tools without a flat end, with y = θ/θ_m as coordinate and one law per factor.
  TiltStore(const std::vector<Factor>& factors, const Drop& drop, double range, double largest)
  {
    constexpr int count = 17;
    // central differences have an error of 1e-10 times the third derivative
    constexpr double step = 1e-5;
    TiltTerms& terms = this->views.terms;
    terms = { range, largest, 0.0, count, count, count, static_cast<int>(factors.size()) };
    const auto slope = [](const auto& f, double at)
    { return (f(at + step) - f(at - step)) / (2.0 * step); };
    for (int k = 0; k < count; ++k)
    {
      const double angle = largest * k / (count - 1);
      this->drops.push_back(drop(angle));
      this->drops.push_back(slope(drop, angle));
    }
    for (const Factor& factor : factors)
    {
      for (int i = 0; i < count; ++i)
      {
        for (int j = 0; j < count; ++j)
        {
          const double x = static_cast<double>(i) / (count - 1);
          const double y = static_cast<double>(j) / (count - 1);
          const auto at = [&](double u, double v) { return factor(range * u * u, largest * v); };
          const auto byX = [&](double v) { return slope([&](double u) { return at(u, v); }, x); };
          this->nodes.push_back(at(x, y));
          this->nodes.push_back(byX(y));
          this->nodes.push_back(slope([&](double v) { return at(x, v); }, y));
          this->nodes.push_back(slope(byX, y));
        }
      }
    }
    this->views.drops = this->drops.data();
    this->views.nodes = this->nodes.data();
  }
  TiltStore(const TiltStore&) = delete;
  TiltStore& operator=(const TiltStore&) = delete;

  std::vector<double> drops;
  std::vector<double> nodes;
  TiltViews views;
};

/// Drop of a sphere, whose tilt about the tip only moves its deepest point.
inline TiltStore::Drop dropOfSphere(double radius)
{
  return [radius](double angle) { return radius * (1.0 - std::cos(angle)); };
}
inline double noFactor(double, double)
{
  return 1.0;
}
} // namespace palpate::testing

#endif
