// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/DahlFriction.h"

#include "Contact/StraightStep.h"

#include <cmath>

namespace palpate
{
namespace
{
constexpr double NearlySliding = 0.99;
}

TangentialForce DahlFriction::update(const StraightStep& step, double limit) noexcept
{
  const double longest = limit / this->Stiffness;
  StraightStep::clip(this->Z, longest);
  if (step.length() > 0.0 && longest > 0.0)
  {
    const double approached = -std::expm1(-step.length() / longest);
    this->Z += approached * (longest * step.direction() - this->Z);
  }
  const bool sliding = this->Z.squaredNorm() >= NearlySliding * NearlySliding * longest * longest;
  return { -this->Stiffness * this->Z, sliding };
}
} // namespace palpate
