// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_BaselineCurves_h
#define palpate_testing_BaselineCurves_h

#include "Identification/BodyFit.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace palpate::testing
{
/// A press of Hertz's paraboloid of 3 mm by 0.4 mm into a half-space, after an approach. Noise,
/// offset and drift are relative to the largest force (the drift per mm); the noise is 0.001.
struct Approach
{
  static constexpr double Modulus = 0.05; ///< E*, MPa
  static constexpr double Depth = 0.4;    ///< mm
  static constexpr double Noise = 0.001;

  double length = 1.0; ///< length of the approach, mm
  int before = 200;    ///< readings before the contact
  int inContact = 80;
  double offset = 0.0;
  double drift = 0.0;

  static double force(double depth)
  {
    return 4.0 / 3.0 * Modulus * std::sqrt(3.0) * std::pow(std::max(depth, 0.0), 1.5);
  }

  IndentationCurve measure(const AxisymmetricTool& tool, std::mt19937& random) const
  {
    std::normal_distribution<double> normal;
    IndentationCurve curve;
    curve.tool = &tool;
    const double unit = force(Depth);
    for (int i = -this->before; i <= this->inContact; ++i)
    {
      const double depth = i < 0 ? this->length * i / this->before : Depth * i / this->inContact;
      curve.deflection.push_back(depth + this->length);
      curve.force.push_back(force(depth) +
        unit * (this->offset + this->drift * (depth + this->length) + Noise * normal(random)));
    }
    return curve;
  }
};
} // namespace palpate::testing

#endif
