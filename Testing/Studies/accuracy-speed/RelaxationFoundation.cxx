// SPDX-License-Identifier: BSD-3-Clause
#include "RelaxationFoundation.h"

#include <algorithm>
#include <cmath>

namespace palpate::testing
{
RelaxationFoundation::RelaxationFoundation(
  double exponent, const PronySeries& series, std::size_t count)
  : Series(series)
  , Elements(count)
{
  // Chords of δ^m between the gaps (j/n)². At each gap the slope changes by the weight of the
  // element.
  const auto gapOf = [count](std::size_t j)
  { return std::pow(static_cast<double>(j) / static_cast<double>(count), 2.0); };
  double slope = 0.0;
  for (std::size_t j = 0; j < count; ++j)
  {
    const double next =
      (std::pow(gapOf(j + 1), exponent) - std::pow(gapOf(j), exponent)) / (gapOf(j + 1) - gapOf(j));
    this->Elements[j].gap = gapOf(j);
    this->Elements[j].weight = next - slope;
    slope = next;
  }
}

void RelaxationFoundation::forget()
{
  for (Element& element : this->Elements)
  {
    element.depth = 0.0;
    element.over.fill(0.0);
  }
}

double RelaxationFoundation::press(double depth, double elapsed)
{
  std::array<double, PronySeries::LargestCount> decay{};
  std::array<double, PronySeries::LargestCount> gain{};
  double stiffening = 0.0;
  for (std::size_t i = 0; i < this->Series.count; ++i)
  {
    const double x = elapsed / this->Series.time[i];
    decay[i] = std::exp(-x);
    gain[i] = -this->Series.strength[i] * std::expm1(-x) / x;
    stiffening += gain[i];
  }
  double force = 0.0;
  for (Element& element : this->Elements)
  {
    double kept = 0.0;
    for (std::size_t i = 0; i < this->Series.count; ++i)
    {
      element.over[i] *= decay[i];
      kept += element.over[i];
    }
    // The depth at which the element has no force: u + Σ h_i = 0.
    const double free = (stiffening * element.depth - kept) / (1.0 + stiffening);
    const double now = std::max(depth - element.gap, free);
    const double way = now - element.depth;
    for (std::size_t i = 0; i < this->Series.count; ++i)
    {
      element.over[i] += gain[i] * way;
    }
    force += element.weight * (now + kept + stiffening * way);
    element.depth = now;
  }
  return std::max(force, 0.0);
}
} // namespace palpate::testing
