// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tilt/TiltedFlat.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
/// Coefficients of z, z², …, from a least-squares fit of f to the table with its relative errors as
/// weights. Constraints: f(3) = 2, f'(3) = 1, f''(3) = 0, and the known work at q = 3.
constexpr std::array<double, 9> RimTerms = { 0.21967052817978971, 1.3781689290941161,
  -6.757712350273644, 25.83380523956624, -62.31965296945057, 92.52030735421076, -81.92991590971977,
  39.62429688339708, -8.050449186485492 };
constexpr double WholeEnd = 3.0; // smallest q at which the end is in full contact

/// ρ as a function of z = √(q/3) < 1, and its first three derivatives.
struct RimWork
{
  double value = 0.0;
  double first = 0.0;
  double second = 0.0;
  double third = 0.0;
};

RimWork rimWork(double z) noexcept
{
  RimWork sum;
  for (std::size_t i = RimTerms.size() + 1; i-- > 0;)
  {
    sum.third = sum.third * z + 3.0 * sum.second;
    sum.second = sum.second * z + 2.0 * sum.first;
    sum.first = sum.first * z + sum.value;
    sum.value = sum.value * z + (i > 0 ? RimTerms[i - 1] : 0.0);
  }
  return sum;
}
} // namespace

TiltedFlatTerm tiltedFlatForce(double q) noexcept
{
  if (q >= WholeEnd)
  {
    return { q - 1.0, 1.0, 0.0 };
  }
  // With q = 3z², f = 3/4 (4 z² ρ + z³ ρ').
  const double z = std::sqrt(q / WholeEnd);
  const RimWork rho = rimWork(z);
  const double byZ = 0.75 * z * (8.0 * rho.value + z * (7.0 * rho.first + z * rho.second));
  const double byZTwice =
    0.75 * (8.0 * rho.value + z * (22.0 * rho.first + z * (10.0 * rho.second + z * rho.third)));
  const double zByQ = 1.0 / (6.0 * z);
  return { 0.75 * z * z * (4.0 * rho.value + z * rho.first), byZ * zByQ,
    (byZTwice - byZ / z) * zByQ * zByQ };
}

TiltedFlatTerm tiltedFlatWork(double s) noexcept
{
  if (s <= 1.0)
  {
    constexpr double twoThirds = 2.0 / 3.0;
    constexpr double square = 5.0 / 27.0;
    return { 1.0 - s * (twoThirds - square * s), 2.0 * square * s - twoThirds, 2.0 * square };
  }
  const double z = 1.0 / std::sqrt(s);
  const RimWork rho = rimWork(z);
  const double zByS = -0.5 * z * z * z;
  const double zByTwice = 0.75 * z * z * z * z * z;
  return { rho.value, rho.first * zByS, rho.second * zByS * zByS + rho.first * zByTwice };
}
} // namespace palpate
