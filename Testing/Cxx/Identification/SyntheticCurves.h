// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_SyntheticCurves_h
#define palpate_testing_SyntheticCurves_h

#include "Identification/BodyFit.h"

#include <cmath>
#include <random>

namespace palpate::testing
{
/// Parameters of a synthetic curve.
struct Readings
{
  int count = 60;
  double depth = 1.5;   ///< depth of the last reading below first contact, mm
  double offset = 0.0;  ///< reading of the instrument at first contact, mm
  double before = 0.15; ///< fraction of the readings that is before first contact
  double noise = 0.0;   ///< of the force, N
};

/// Makes a curve for a law F(δ), which may be any callable.
template <class Law>
IndentationCurve makeCurve(
  const AxisymmetricTool& tool, const Law& law, const Readings& readings, std::mt19937& random)
{
  std::normal_distribution<double> normal;
  IndentationCurve curve;
  curve.tool = &tool;
  for (int i = 0; i < readings.count; ++i)
  {
    const double share = (i + 0.5) / readings.count;
    const double depth = readings.depth * (share - readings.before) / (1.0 - readings.before);
    curve.deflection.push_back(readings.offset + depth);
    curve.force.push_back((depth > 0.0 ? law(depth) : 0.0) + readings.noise * normal(random));
  }
  return curve;
}

/// Force of Hertz's paraboloid of radius R in series with a compliance C. By bisection over the
/// force in the closed form δ = (3F/4E*√R)^(2/3) + C F.
inline double hertzInSeries(double R, double modulus, double compliance, double depth)
{
  double low = 0.0;
  double high = 4.0 / 3.0 * modulus * std::sqrt(R) * std::pow(depth, 1.5);
  for (int i = 0; i < 100; ++i)
  {
    const double force = 0.5 * (low + high);
    const double total =
      std::cbrt(std::pow(0.75 * force / (modulus * std::sqrt(R)), 2.0)) + compliance * force;
    (total < depth ? low : high) = force;
  }
  return 0.5 * (low + high);
}
} // namespace palpate::testing

#endif
