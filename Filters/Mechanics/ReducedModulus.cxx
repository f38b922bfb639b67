// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/ReducedModulus.h"

#include <cmath>
#include <limits>

namespace palpate
{
bool isYoungsModulus(double youngsModulus)
{
  return std::isfinite(youngsModulus) && youngsModulus > 0.0;
}

bool isPoissonsRatio(double poissonsRatio)
{
  return poissonsRatio >= 0.0 && poissonsRatio <= 0.5;
}

double reducedModulus(double youngsModulus, double poissonsRatio)
{
  if (!isYoungsModulus(youngsModulus) || !isPoissonsRatio(poissonsRatio))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return youngsModulus / (1.0 - poissonsRatio * poissonsRatio);
}
} // namespace palpate
