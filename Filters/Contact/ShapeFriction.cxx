// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/ShapeFriction.h"

#include "Contact/StraightStep.h"

namespace palpate
{
namespace
{
constexpr double NearlyAll = 1.0 - 1e-9;
}

ShapeFriction::ShapeFriction(const FrictionSettings& settings) noexcept
  : Coefficient(settings.coefficient)
  , Compliance((2.0 - settings.poissonRatio) / (2.0 * (1.0 - settings.poissonRatio)))
{
  this->Stiffness.fill(0.0);
  this->Displacement.fill(Vector2::Zero());
}

void ShapeFriction::reset() noexcept
{
  this->Count = 0;
}

TangentialForce ShapeFriction::move(
  const Vector2& displacement, const Springs& springs, double deflection) noexcept
{
  const StraightStep step(displacement);
  TangentialForce result;
  for (std::size_t j = 0; j < springs.count; ++j)
  {
    const double stiffness = springs.stiffness[j];
    const double limit = this->Coefficient * this->Compliance * (deflection - springs.level[j]);
    Vector2 u = Vector2::Zero();
    if (j < this->Count)
    {
      u = this->Displacement[j];
      if (stiffness > this->Stiffness[j])
      {
        u *= this->Stiffness[j] / stiffness;
      }
      StraightStep::clip(u, limit);
    }
    if (step.length() > 0.0 && limit > 0.0)
    {
      u = step.toPath(u);
      const double left = StraightStep::moveFreely(u, limit, step.length());
      if (left > 0.0)
      {
        StraightStep::drag(u, limit, left);
      }
      u = step.fromPath(u);
    }
    const double nearly = NearlyAll * limit;
    result.sliding = result.sliding && (stiffness == 0.0 || u.squaredNorm() >= nearly * nearly);
    this->Stiffness[j] = stiffness;
    this->Displacement[j] = u;
    result.force -= stiffness * u;
  }
  this->Count = springs.count;
  result.force /= this->Compliance;
  return result;
}
} // namespace palpate
