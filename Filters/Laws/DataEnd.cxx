// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/DataEnd.h"

#include "Contact/ResponseSampling.h"

#include <limits>

namespace palpate
{
namespace
{
constexpr double Storage = 1e-3;
// Number of bisections of the interval between two samples; sufficient for the precision of a
// float.
constexpr int Halvings = 24;
} // namespace

double depthOfDataEnd(const ResponseSampling& sampling, double range, const float* force,
  const float* stiffness, const DataEnd& end)
{
  const FloatCurve curve{ force, stiffness };
  const double largestForce = end.force * (1.0 + Storage);
  const double largestStiffness = end.stiffness * (1.0 + Storage);
  const auto beyond = [&](double f, double k) { return f > largestForce || k > largestStiffness; };
  int i = 0;
  while (i < sampling.samples() && !beyond(curve.force(i), curve.stiffness(i)))
  {
    ++i;
  }
  if (i == sampling.samples())
  {
    return std::numeric_limits<double>::infinity();
  }
  // Force and stiffness increase with depth. Therefore there is exactly one crossing, between
  // samples i - 1 and i.
  double low = i > 0 ? sampling.depth(i - 1, range) : 0.0;
  double high = sampling.depth(i, range);
  for (int k = 0; k < Halvings; ++k)
  {
    const double middle = 0.5 * (low + high);
    const ResponseValue value = sampling.evaluate(curve, range, middle);
    (beyond(value.force, value.stiffness) ? high : low) = middle;
  }
  return low;
}
} // namespace palpate
