// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/Friction.h"

#include <cmath>

namespace palpate
{
namespace
{
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
} // namespace palpate
