// SPDX-License-Identifier: BSD-3-Clause
#include "ContractCurve.h"

#include <cmath>
#include <cstddef>

namespace palpate::testing
{
ContractValue ContractCurve::evaluate(double depth) const
{
  using Real = long double;
  const std::size_t n = this->force.size();
  const Real m = this->exponent;
  const Real range_ = this->range;
  const Real d = depth;
  const auto depthOf = [&](std::size_t i) // i = 1 … n
  { return range_ * static_cast<Real>(i * i) / static_cast<Real>(n * n); };
  const auto forceOf = [&](std::size_t i) { return static_cast<Real>(this->force[i - 1]); };
  const auto stiffnessOf = [&](std::size_t i) { return static_cast<Real>(this->stiffness[i - 1]); };
  const auto answer = [](Real f, Real k, bool beyond) {
    return ContractValue{ static_cast<double>(f), static_cast<double>(k), beyond };
  };

  if (d <= 0)
  {
    return {};
  }
  if (d >= range_)
  {
    return answer(forceOf(n) + stiffnessOf(n) * (d - range_), stiffnessOf(n), d > range_);
  }
  if (d < depthOf(1))
  {
    if (forceOf(1) == 0)
    {
      return {};
    }
    const Real q = stiffnessOf(1) * depthOf(1) / forceOf(1);
    const Real f = forceOf(1) * std::pow(d / depthOf(1), q);
    return answer(f, f * q / d, false);
  }
  std::size_t i = 1;
  while (i + 1 < n && d >= depthOf(i + 1))
  {
    ++i;
  }
  // r = F δ^-m; dr/dδ = K δ^-m - m F δ^(-m-1); δ = δ_max s², dδ/ds = 2 δ_max s.
  const auto valueOf = [&](std::size_t k) { return forceOf(k) * std::pow(depthOf(k), -m); };
  const auto slopeOf = [&](std::size_t k)
  {
    const Real dk = depthOf(k);
    const Real perDepth = stiffnessOf(k) * std::pow(dk, -m) - m * forceOf(k) * std::pow(dk, -m - 1);
    return perDepth * 2 * range_ * static_cast<Real>(k) / static_cast<Real>(n);
  };
  const Real s = std::sqrt(d / range_);
  const Real h = 1 / static_cast<Real>(n);
  const Real t = (s - static_cast<Real>(i) * h) / h;
  const Real h00 = (1 + 2 * t) * (1 - t) * (1 - t);
  const Real h10 = t * (1 - t) * (1 - t);
  const Real h01 = t * t * (3 - 2 * t);
  const Real h11 = t * t * (t - 1);
  const Real r =
    h00 * valueOf(i) + h10 * h * slopeOf(i) + h01 * valueOf(i + 1) + h11 * h * slopeOf(i + 1);
  const Real rSlope = (6 * t * t - 6 * t) / h * (valueOf(i) - valueOf(i + 1)) +
    (3 * t * t - 4 * t + 1) * slopeOf(i) + (3 * t * t - 2 * t) * slopeOf(i + 1);
  const Real f = std::pow(d, m) * r;
  const Real k = m * std::pow(d, m - 1) * r + std::pow(d, m) * rSlope / (2 * range_ * s);
  return answer(f, k, false);
}
} // namespace palpate::testing
