// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/RisingStiffness.h"

namespace palpate
{
namespace
{
using Cubic = std::array<double, 4>; // polynomial in t, constant term first

/// Returns a cubic that has the sign of dK/dδ, for the cubic ρ of an interval that begins at
/// `first` times the interval width.
Cubic slopeOfStiffness(const Cubic& rho, double first, double p)
{
  const double a = first;
  const Cubic once{ a * rho[1], rho[1] + 2.0 * a * rho[2], 2.0 * rho[2] + 3.0 * a * rho[3],
    3.0 * rho[3] }; // s ρ'
  const Cubic twice{ 2.0 * a * a * rho[2], 4.0 * a * rho[2] + 6.0 * a * a * rho[3],
    2.0 * rho[2] + 12.0 * a * rho[3], 6.0 * rho[3] }; // s² ρ''
  Cubic sum{};
  for (std::size_t i = 0; i < sum.size(); ++i)
  {
    sum[i] = p * (p - 2.0) * rho[i] + (2.0 * p - 1.0) * once[i] + twice[i];
  }
  return sum;
}

Cubic toBernstein(const Cubic& c)
{
  return { c[0], c[0] + c[1] / 3.0, c[0] + (2.0 * c[1] + c[2]) / 3.0, c[0] + c[1] + c[2] + c[3] };
}
} // namespace

RisingStiffness::RisingStiffness(const ResponseSampling& sampling)
  : FirstDepth(sampling.depth(0, 1.0))
{
  const double p = 2.0 * sampling.exponent();
  const double h = 1.0 / sampling.samples();
  for (int i = 1; i < sampling.samples(); ++i)
  {
    Cell cell{};
    const auto add = [&](int sample, std::size_t force, const Cubic& value, const Cubic& slope)
    {
      // ρ = w F and dρ/dt = h w (2 δ_max s K - p F/s) at this sample.
      const double s = h * sample;
      const double weight = std::pow(s, -p);
      const Cubic ofValue = toBernstein(slopeOfStiffness(value, i, p));
      const Cubic ofSlope = toBernstein(slopeOfStiffness(slope, i, p));
      for (std::size_t j = 0; j < cell.size(); ++j)
      {
        cell[j][force] = weight * (ofValue[j] - h * p / s * ofSlope[j]);
        cell[j][force + 1] = weight * 2.0 * h * s * ofSlope[j];
      }
    };
    add(i, 0, { 1.0, 0.0, -3.0, 2.0 }, { 0.0, 1.0, -2.0, 1.0 });
    add(i + 1, 2, { 0.0, 0.0, 3.0, -2.0 }, { 0.0, 0.0, -1.0, 1.0 });
    this->Cells.push_back(cell);
  }
}
} // namespace palpate
