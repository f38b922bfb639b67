// SPDX-License-Identifier: BSD-3-Clause
#include "Strain/GradedMesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
/// Returns the largest element size at x. Inside a range it is the size of the range; outside it
/// increases with the distance from the range.
double sizeAt(double x, const std::vector<FineRange>& fine, double growth)
{
  double size = HUGE_VAL;
  for (const FineRange& range : fine)
  {
    const double away = std::max({ 0.0, range.from - x, x - range.to });
    size = std::min(size, range.size + (growth - 1.0) * away);
  }
  return size;
}
} // namespace

std::vector<double> gradedDivision(
  double end, const std::vector<FineRange>& fine, double growth, const std::vector<double>& through)
{
  std::vector<double> stops = through;
  stops.push_back(end);
  std::vector<double> ends = { 0.0 };
  for (const double stop : stops)
  {
    const double start = ends.back();
    std::vector<double> inner;
    double x = start;
    while (x < stop)
    {
      // The smaller size at the two ends of the element is used, so that the elements become small
      // before a range begins.
      const double size = sizeAt(x, fine, growth);
      x += std::min(size, std::max(sizeAt(x + size, fine, growth), size / growth));
      inner.push_back(x);
    }
    // The part of the last element beyond the end is distributed over all elements.
    const std::size_t count = inner.size();
    const bool dropsLast =
      count > 1 && stop - inner[count - 2] < 0.5 * (inner[count - 1] - inner[count - 2]);
    inner.resize(count - (dropsLast ? 1 : 0));
    const double factor = (stop - start) / (inner.back() - start);
    for (const double position : inner)
    {
      ends.push_back(start + factor * (position - start));
    }
    ends.back() = stop;
  }
  return ends;
}
} // namespace palpate
