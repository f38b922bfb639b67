// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/Estimate.h"

#include "Mechanics/Numerics/Constants.h"

#include <cmath>

namespace palpate
{
Estimate logarithmicEstimate(double value, double error)
{
  return { value, value * std::exp(-error), value * std::exp(error) };
}

Estimate linearEstimate(double value, double error)
{
  return { value, value - error, value + error };
}

double studentQuantile(double degreesOfFreedom)
{
  const double z = Normal95;
  const double z3 = z * z * z;
  const double z5 = z3 * z * z;
  const double z7 = z5 * z * z;
  const double n = degreesOfFreedom;
  return z + (z3 + z) / (4.0 * n) + (5.0 * z5 + 16.0 * z3 + 3.0 * z) / (96.0 * n * n) +
    (3.0 * z7 + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / (384.0 * n * n * n);
}
} // namespace palpate
