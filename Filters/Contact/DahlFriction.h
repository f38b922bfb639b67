// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DahlFriction_h
#define palpate_DahlFriction_h

#include "Contact/ContactSettings.h"
#include "Contact/FrictionFrame.h"
#include "Mechanics/PalpateExport.h"

#include <cmath>

namespace palpate
{
/**
 * Dahl's friction (1968), the baseline of the studies: dz = dx - |dx| z/z_max, force -σ₀ z, with
 * z_max = limit/σ₀. Creeps from the first displacement on, and so drifts under a load that swings
 * within the limit, z_max [ln((1-z₁)/(1-z₂)) - ln((1+z₂)/(1+z₁))] per cycle (z in units of z_max).
 *
 * Along a straight step the equation is linear and solved exactly: z e^-y/z_max + z_max (1 -
 * e^-y/z_max) d. So it does not matter in how many ticks a way is gone; the explicit step of
 * Hayward and Armstrong 2000 would slide at z_max - |dx|, at a force that depends on speed.
 *
 * It comes near the limit but never reaches it: sliding is from 99 % on. On a circle of radius ρ it
 * lags by atan(z_max/ρ), with cos of that of the limit.
 */
class PALPATE_EXPORT DahlFriction
{
public:
  explicit DahlFriction(const FrictionSettings& settings) noexcept
    : Stiffness(settings.tangentialStiffness)
  {
  }
  void reset() noexcept { this->Z.setZero(); }

  /// At most `limit` = μ f_n, N.
  TangentialForce update(const StraightStep& step, double limit) noexcept
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

private:
  static constexpr double NearlySliding = 0.99;

  double Stiffness;
  Vector2 Z = Vector2::Zero();
};
} // namespace palpate

#endif
