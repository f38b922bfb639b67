// SPDX-License-Identifier: BSD-3-Clause
#include "Friction.h"

#include <cmath>

namespace palpate
{
namespace
{
constexpr double UnitTolerance = 1e-3;

bool isValid(const FrictionSettings& settings)
{
  const auto isPositive = [](double value) { return value > 0.0 && std::isfinite(value); };
  if (settings.model == FrictionModel::ShapeDerived)
  {
    return isPositive(settings.coefficient) && settings.poissonRatio > -1.0 &&
      settings.poissonRatio <= 0.5;
  }
  return isPositive(settings.coefficient) && isPositive(settings.tangentialStiffness) &&
    settings.breakaway >= 0.0 && settings.breakaway <= 1.0 && settings.stickRadius >= 0.0 &&
    std::isfinite(settings.stickRadius);
}
} // namespace

Friction::Friction(const FrictionSettings& settings) noexcept
  : Model(settings.model)
  , Enabled(isValid(settings))
  , Coefficient(settings.coefficient)
  , ElastoPlastic(settings)
  , Dahl(settings)
  , Shape(settings)
{
}

void Friction::reset() noexcept
{
  this->Frame.reset();
}

/// Whether there is a contact that makes sense.
bool Friction::advance(const Vector3& contactPoint, const Vector3& normal, double normalForce,
  double deflection) noexcept
{
  const double finite = contactPoint.sum() + normalForce + deflection;
  const bool isUnit = std::abs(normal.squaredNorm() - 1.0) < UnitTolerance;
  if (!std::isfinite(finite) || !isUnit)
  {
    this->Frame.reset();
    return false;
  }
  if (!this->Frame.advance(contactPoint, normal))
  {
    this->ElastoPlastic.reset();
    this->Dahl.reset();
    this->Shape.reset();
  }
  return true;
}
} // namespace palpate
