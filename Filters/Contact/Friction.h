// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_Friction_h
#define palpate_Friction_h

#include "Contact/ContactSettings.h"
#include "Contact/FrictionModels.h"
#include "Contact/FrictionFrame.h"
#include "Mechanics/PalpateExport.h"

#include <cmath>

namespace palpate
{
/**
 * What resists the sliding of one contact: a tangential force from the pre-sliding displacement of
 * the contact point over the undeformed surface (Mahvash and Hayward 2002, section 3). The normal
 * force is not changed by it.
 *
 * The displacement is a vector in the tangent plane and is carried over curved bodies by parallel
 * transport (FrictionFrame); what force it gives is up to FrictionSettings::model. All three depend
 * on the way, not on time nor on the number of ticks the way takes; their force never exceeds
 * Coulomb's limit μ f_n.
 *
 * Energy: from first touch on, the work against friction along the displacements over the surface
 * is never negative, however point, depth, normal force and response change (for short ticks; a
 * servo loop that holds the force for a period leaks what any spring does). The tip itself, δ deep
 * under a curvature κ, moves 1 - δκ times as far.
 *
 * One Friction is one history. No heap; update() neither throws nor waits.
 *
 * Cost of an update: 40 ns (stuck) to 70 ns (sliding under a changing load) with
 * ElastoPlastic and Dahl, 0.5 to 2.5 µs for ShapeDerived; nothing with coefficient 0.
 */
class PALPATE_EXPORT Friction
{
public:
  /// Settings out of their range give no friction.
  explicit Friction(const FrictionSettings& settings) noexcept;

  /// Contact lost: the next one starts without pre-sliding displacement.
  void reset() noexcept;

  /// What resists sliding in one tick.
  struct Result
  {
    Vector3 force = Vector3::Zero(); ///< on the tool, tangential, N
    bool sliding = true;             ///< Coulomb's limit is reached; else the contact sticks
  };

  /// The contact of this tick: point on the undeformed surface, mm; unit outward normal; normal
  /// force, N; depth δ, mm; the response there, with evaluate(depth) -> ResponseValue and range()
  /// -> mm (only used by ShapeDerived). The first after reset() gives no force.
  /// What is not finite, or a normal not of unit length, gives none and ends the history.
  template <class Curve>
  [[gnu::hot]] Result update(const Vector3& contactPoint, const Vector3& normal, double normalForce,
    double deflection, const Curve& curve) noexcept
  {
    if (!this->Enabled || !this->advance(contactPoint, normal, normalForce, deflection))
    {
      return {};
    }
    const StraightStep& step = this->Frame.step();
    const double load = normalForce > 0.0 ? normalForce : 0.0;
    const double limit = this->Coefficient * load;
    TangentialForce tangential;
    switch (this->Model)
    {
      case FrictionModel::ElastoPlastic:
        tangential = this->ElastoPlastic.update(step, limit);
        break;
      case FrictionModel::Dahl:
        tangential = this->Dahl.update(step, limit);
        break;
      case FrictionModel::ShapeDerived:
        tangential = this->Shape.update(step.displacement(), load, deflection, curve);
        break;
    }
    return { this->Frame.toSpace(tangential.force), tangential.sliding };
  }

private:
  bool advance(const Vector3& contactPoint, const Vector3& normal, double normalForce,
    double deflection) noexcept;
  static constexpr double UnitTolerance = 1e-3; ///< of the squared length of a normal

  FrictionModel Model;
  bool Enabled;
  double Coefficient;
  FrictionFrame Frame;
  ElastoPlasticFriction ElastoPlastic;
  DahlFriction Dahl;
  ShapeFriction Shape;
};
/// Whether there is a contact that makes sense.
inline bool Friction::advance(const Vector3& contactPoint, const Vector3& normal,
  double normalForce, double deflection) noexcept
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

#endif
