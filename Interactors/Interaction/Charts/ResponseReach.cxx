// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Charts/ResponseReach.h"

#include "Response/BodyConversion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
double sampleOf(const ResponseArrays& arrays, std::size_t point, std::size_t sample)
{
  const auto count = static_cast<std::size_t>(arrays.samples);
  if (arrays.force)
  {
    return arrays.force[count * point + sample];
  }
  double sum = 0.0;
  const auto laws = static_cast<std::size_t>(arrays.laws);
  for (std::size_t k = 0; k < laws; ++k)
  {
    sum += static_cast<double>(arrays.coefficient[laws * point + k]) *
      static_cast<double>(arrays.basis[2 * count * k + sample]);
  }
  return sum;
}

/// Returns the index of the first sample at or beyond this deflection, or of the last sample if
/// there is none. Sample i has the deflection range (i/n)^2.
std::size_t sampleAt(double deflection, double range, int samples)
{
  const double place = std::ceil(samples * std::sqrt(deflection / range) - 1e-6) - 1.0;
  return static_cast<std::size_t>(std::clamp(place, 0.0, samples - 1.0));
}
} // namespace

ResponseReach ResponseReach::of(vtkPolyData* body, const std::string& name, double deflection)
{
  ResponseReach reach;
  ResponseArrays arrays;
  std::string error;
  if (!body || !viewResponse(body, name, arrays, error))
  {
    return reach;
  }
  double longest = 0.0;
  for (std::size_t i = 0; i < arrays.points; ++i)
  {
    longest =
      arrays.isUsable(i) ? std::max(longest, static_cast<double>(arrays.range[i])) : longest;
  }
  reach.deflection = deflection > 0.0 ? deflection : longest;
  for (std::size_t i = 0; i < arrays.points; ++i)
  {
    if (arrays.isUsable(i))
    {
      const double range = arrays.range[i];
      const auto force = [&](double depth)
      { return sampleOf(arrays, i, sampleAt(depth, range, arrays.samples)); };
      reach.force = std::max(reach.force, force(reach.deflection));
      reach.halfForce = std::max(reach.halfForce, force(0.5 * reach.deflection));
    }
  }
  return reach;
}
} // namespace palpate
