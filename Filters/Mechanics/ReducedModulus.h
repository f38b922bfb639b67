// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ReducedModulus_h
#define palpate_ReducedModulus_h

#include <cmath>
#include <limits>

namespace palpate
{
/// Returns whether E is a valid Young's modulus: finite and positive (MPa).
inline bool isYoungsModulus(double youngsModulus)
{
  return std::isfinite(youngsModulus) && youngsModulus > 0.0;
}

/// Returns whether nu is a Poisson's ratio for which the half-space laws are valid: 0 <= nu <= 0.5.
inline bool isPoissonsRatio(double poissonRatio)
{
  return poissonRatio >= 0.0 && poissonRatio <= 0.5;
}

/// Returns E* = E / (1 - nu^2) for a rigid tool, in the unit of E (MPa). NaN if E or nu is outside
/// its range.
inline double reducedModulus(double youngsModulus, double poissonRatio)
{
  if (!isYoungsModulus(youngsModulus) || !isPoissonsRatio(poissonRatio))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return youngsModulus / (1.0 - poissonRatio * poissonRatio);
}
} // namespace palpate

#endif
