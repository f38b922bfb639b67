// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ElastoPlasticFriction_h
#define palpate_ElastoPlasticFriction_h

#include "Contact/ContactSettings.h"
#include "Contact/FrictionFrame.h"
#include "Mechanics/PalpateExport.h"

namespace palpate
{
/**
 * Elasto-plastic friction of Hayward and Armstrong 2000: stick, creep, slide.
 *
 * The contact point's displacement x over the surface is elastic, z, plus plastic, w; the force is
 * -σ₀ z. Forwards (dx along z) a share of the displacement is plastic,
 *   dw = α(|z|) z (dx·z/|z|),   and |z| <= z_max = limit/σ₀;
 * backwards none is: a contact unloads elastically (Dupont, Hayward, Armstrong and Altpeter 2002).
 * With r = |z|/z_max, b = breakaway, s = stick radius, both in units of z_max:
 *   α z_max = w/(w + s⁸ - b⁸),   w = max(r⁸ - b⁸, 0).
 * b = 0 is α = z⁸/(z_st⁸ + z⁸)/z_max, as Hayward and Armstrong write it; b = s = 1 their stick and
 * slide.
 *
 * Why b > 0: α small is not α = 0. Under 0.1 kg, 0.5 ± 0.2 of the limit at 2 Hz, z⁸ alone creeps by
 * 6 µm per cycle at s = 0.9 and 0.2 mm at s = 0.5 (z_max = 1 mm), and goes on. That a contact stays
 * where it is needs a neighbourhood of z = 0 in which α is exactly 0, as Dupont et al. prove.
 *
 * Why the displacement counts forwards only: with |dx| instead, z would be stiffer than σ₀ on the
 * way back (up to 2 σ₀, past what the loop was made stable for), and shrink under displacements
 * across it. At the limit this is Coulomb's law with the force against the sliding direction.
 *
 * A step of any length goes, in this order, the free way to the breakaway circle and, at the limit,
 * the tractrix, both exactly; between them the creep by fourth-order Runge-Kutta in pieces of at
 * most 1/8 z_max, at most 40 (within 2e-5 of the limit). On a circle of radius ρ > z_max the force
 * is at the limit and lags by asin(z_max/ρ).
 *
 * σ₀ is constant and |z| clipped, so that a changing normal force takes energy but creates none
 * (σ₀ = limit/z_max would create ½ z² Δσ₀ per cycle).
 */
class PALPATE_EXPORT ElastoPlasticFriction
{
public:
  explicit ElastoPlasticFriction(const FrictionSettings& settings) noexcept;
  void reset() noexcept { this->Z.setZero(); }

  /// At most `limit` = μ f_n, N.
  TangentialForce update(const StraightStep& step, double limit) noexcept;

private:
  bool finishCreep(Vector2& z, double longest, double& length) const noexcept;
  double creep(Vector2& z, double longest, double length) const noexcept;
  Vector2 rate(const Vector2& z, double longest) const noexcept;
  Vector2 rungeKutta(const Vector2& z, double longest, double length) const noexcept;

  double Stiffness;
  double Breakaway;
  double Breakaway8; ///< b⁸
  double Width8;     ///< s⁸ - b⁸
  Vector2 Z = Vector2::Zero();
};
} // namespace palpate

#endif
