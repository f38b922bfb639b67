// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_FrictionCurves_h
#define palpate_testing_FrictionCurves_h

#include "Contact/Friction.h"
#include "Contact/ResponseSampling.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace palpate::testing
{
inline constexpr FrictionModel FrictionModels[] = { FrictionModel::ElastoPlastic,
  FrictionModel::Dahl, FrictionModel::ShapeDerived };

/// Settings with a coefficient μ and a stiffness in N/mm; the other settings have their defaults.
inline FrictionSettings frictionOf(FrictionModel model, double coefficient, double stiffness)
{
  FrictionSettings settings;
  settings.model = model;
  settings.coefficient = coefficient;
  settings.tangentialStiffness = stiffness;
  return settings;
}

/// k δ^q, the response of a flat end, a paraboloid and a cone on a half-space, without sampling.
struct PowerCurve
{
  double factor = 10.0;
  double exponent = 1.5;
  double depth = 2.0; ///< range, mm

  ResponseValue evaluate(double deflection) const
  {
    if (!(deflection > 0.0))
    {
      return {};
    }
    const double force = this->factor * std::pow(deflection, this->exponent);
    return { force, this->exponent * force / deflection, deflection > this->depth };
  }
  double force(double deflection) const { return this->evaluate(deflection).force; }
  double range() const { return this->depth; }
};

/// The same curve stored in 8 samples, as in a body.
class StoredCurve
{
public:
  explicit StoredCurve(const PowerCurve& curve)
    : Sampling(8, curve.exponent)
    , Range(curve.depth)
  {
    for (int i = 0; i < this->Sampling.samples(); ++i)
    {
      const ResponseValue value = curve.evaluate(this->Sampling.depth(i, this->Range));
      this->Samples.forces.push_back(value.force);
      this->Samples.stiffnesses.push_back(value.stiffness);
    }
  }

  ResponseValue evaluate(double deflection) const
  {
    return this->Sampling.evaluate(this->Samples, this->Range, deflection);
  }
  double range() const { return this->Range; }

private:
  struct Columns
  {
    std::vector<double> forces;
    std::vector<double> stiffnesses;
    double force(int i) const { return this->forces[static_cast<std::size_t>(i)]; }
    double stiffness(int i) const { return this->stiffnesses[static_cast<std::size_t>(i)]; }
  };

  ResponseSampling Sampling;
  double Range;
  Columns Samples;
};
} // namespace palpate::testing

#endif
