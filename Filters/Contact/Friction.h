// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_Friction_h
#define palpate_Friction_h

#include "Contact/ContactSettings.h"
#include "Contact/FrictionFrame.h"
#include "Contact/ResponseSampling.h"
#include "Mechanics/PalpateExport.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace palpate
{
/**
 * Dahl's friction (1968), the baseline of the studies: dz = dx - |dx| z/z_max, force -σ₀ z, with
 * z_max = limit/σ₀. The model creeps under any displacement, however small. Under a load that
 * varies within the limit it therefore drifts by z_max [ln((1-z₁)/(1-z₂)) - ln((1+z₂)/(1+z₁))] per
 * cycle (z in units of z_max).
 *
 * Along a straight step of length y and direction d the equation is linear and solved exactly:
 *   z e^(-y/z_max) + z_max (1 - e^(-y/z_max)) d.
 * Therefore the number of ticks on a path has no influence. The explicit step of Hayward and
 * Armstrong 2000 would slide at z_max - |dx|, at a force that depends on speed.
 *
 * The force approaches the limit but never reaches it: 99 % counts as sliding. On a circle of
 * radius ρ the force lags by atan(z_max/ρ), and its magnitude is the limit times the cosine of that
 * angle.
 */
class PALPATE_EXPORT DahlFriction
{
public:
  explicit DahlFriction(const FrictionSettings& settings) noexcept
    : Stiffness(settings.tangentialStiffness)
  {
  }
  void reset() noexcept { this->Z.setZero(); }
  double stiffness() const noexcept { return this->Stiffness; } ///< σ₀, N/mm
  /// The elastic displacement z, mm.
  const Vector2& displacement() const noexcept { return this->Z; }
  void setDisplacement(const Vector2& displacement) noexcept { this->Z = displacement; }

  /// Returns a force of at most `limit` = μ f_n, N.
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

/**
 * Elasto-plastic friction of Hayward and Armstrong 2000: stick, creep, slide.
 *
 * The displacement x of the contact point over the surface is the sum of an elastic part z and a
 * plastic part w; the force is -σ₀ z. If dx has a component along z, a part of the displacement is
 * plastic,
 *   dw = α(|z|) z (dx·z/|z|),   and |z| <= z_max = limit/σ₀.
 * If dx is directed against z, no displacement is plastic: a contact unloads elastically (Dupont,
 * Hayward, Armstrong and Altpeter 2002). With r = |z|/z_max, b = breakaway, s = stick radius, both
 * in units of z_max:
 *   α z_max = w/(w + s⁸ - b⁸),   w = max(r⁸ - b⁸, 0).
 * b = 0 gives α = z⁸/(z_st⁸ + z⁸)/z_max, as in Hayward and Armstrong; b = s = 1 gives their
 * stick-slip model.
 *
 * Reason for b > 0: a small α still causes drift. Under 0.1 kg, 0.5 ± 0.2 of the limit at 2 Hz, z⁸
 * alone creeps by 6 µm per cycle at s = 0.9 and by 0.2 mm at s = 0.5 (z_max = 1 mm), without end. A
 * contact does not drift only if α is exactly 0 in a neighbourhood of z = 0, as Dupont et al.
 * prove.
 *
 * Reason for counting only the displacement along z: with |dx| instead, the contact would unload
 * more stiffly than σ₀ (up to 2 σ₀, more than the stability of the loop was designed for). z would
 * also shrink under displacements across z. At the limit the model is Coulomb's law with the force
 * against the sliding direction.
 *
 * A step of any length has three parts in this order: elastic motion to the breakaway circle,
 * creep, and the tractrix at the limit. Elastic motion and tractrix are exact. Creep is integrated
 * by fourth-order Runge-Kutta in pieces of at most 1/8 z_max, at most 40 pieces (within 2e-5 of the
 * limit). On a circle of radius ρ > z_max the force is at the limit and lags by asin(z_max/ρ).
 *
 * σ₀ is constant and |z| is clipped, so that a changing normal force dissipates energy but never
 * creates it (σ₀ = limit/z_max would create ½ z² Δσ₀ per cycle).
 */
class PALPATE_EXPORT ElastoPlasticFriction
{
public:
  explicit ElastoPlasticFriction(const FrictionSettings& settings) noexcept;
  void reset() noexcept { this->Z.setZero(); }
  double stiffness() const noexcept { return this->Stiffness; } ///< σ₀, N/mm
  /// The elastic displacement z, mm.
  const Vector2& displacement() const noexcept { return this->Z; }
  void setDisplacement(const Vector2& displacement) noexcept { this->Z = displacement; }

  /// Returns a force of at most `limit` = μ f_n, N.
  TangentialForce update(const StraightStep& step, double limit) noexcept;

private:
  /// Handles a step in which the contact only slides. Returns false and changes nothing for other
  /// steps.
  bool slideOn(const StraightStep& step, double longest, double inverse) noexcept;
  double creep(Vector2& z, double longest, double length) const noexcept;
  Vector2 rate(const Vector2& z, double longest) const noexcept;
  Vector2 rungeKutta(const Vector2& z, double longest, double length) const noexcept;

  double Stiffness;
  double Breakaway;
  double Breakaway8; ///< b⁸
  double Width8;     ///< s⁸ - b⁸
  double InverseWidth8;
  Vector2 Z = Vector2::Zero();
};

/**
 * Friction computed from the stored response f(δ); its only parameters are μ and ν.
 *
 * If normal and tangential contact are similar (Jaeger 1998; Ciavarella 1998; for spheres Mindlin
 * 1949), a displacement u at constant depth causes the force
 *   Q(u) = μ [f(δ) - f(δ - u/(μc))],   c = (2-ν)/(2(1-ν)),
 * and the contact slides for u >= μcδ. In the method of dimensionality reduction (Popov and Hess
 * 2015) the contact is a row of springs: springs of stiffness f''(η) dη touch when the depth passes
 * the level η; for a flat end, springs of stiffness f'(0) touch at level 0. A spring of normal
 * stiffness k has the tangential stiffness k/c and a separate displacement u. It slides at |u| =
 * μc(δ - η), where its force is μ times its load. The history (loading under a varying depth,
 * reversals by Masing's rule, curved paths) is stored in these u, all vectors in the tangent plane.
 *
 * The depths range·(j/Cells)² divide the depth into cells; the last cell ends at δ. Each cell has
 * `PerCell` springs. Force and stiffness of the response at the ends of a cell give stiffness and
 * load of its springs. Therefore all springs together carry exactly f(δ) at any depth, and slide at
 * exactly μ f_n. Cells are fixed in depth (on a body of one range), so that springs keep their
 * history as δ changes:
 * - δ grows: the last cell gets wider and stiffer, then further cells follow, initially without
 *   displacement;
 * - δ decreases: the limits and with them the displacements decrease; springs whose cell is above δ
 *   are removed, when they no longer have a force;
 * - beyond the range: no further springs, because the response continues along its last tangent;
 *   the limits grow;
 * - below range/256, where the force is less than a thousandth of its largest value: one cell.
 *
 * Energy: a spring that gets stiffer keeps its force, not its displacement. A spring that gets
 * softer keeps its displacement. In both cases energy is lost, so that no change of depth, force or
 * response along the path can create energy. The disadvantage: if the response differs from point
 * to point, a stuck contact that is moved back and forth creeps by that difference.
 *
 * If a response is not convex (f'' < 0, or measured with noise), cells of falling stiffness have no
 * spring, and the other springs are scaled to carry f_n. They are also scaled if f_n is not the
 * force of the curve (ForceForm::Paper).
 *
 * Largest error of Q, divided by μ f_n, for paraboloid / cone (for a flat only rounding):
 *   springs      16             32             64            16 cells of 4
 *   at range     1.4e-3/3.6e-3  3.4e-4/9.0e-4  8.5e-5/2.2e-4  9.3e-5/2.2e-4
 *   at range/4   5.5e-3/1.4e-2  1.4e-3/3.6e-3  3.4e-4/9.0e-4  4.5e-4/8.5e-4
 * The error falls with the square of the number of springs, however they are distributed over
 * cells. A cell costs an evaluation of the response, a spring only a few operations. Therefore 16
 * cells of 4 springs are used: the error is below 1e-3, like that of 8 samples of the response,
 * with a quarter of the evaluations of 64 cells.
 *
 * Cost, in addition to one evaluation of the response per cell within the depth: 5 to 25 ns per
 * spring (stuck or straight; sliding on a curve needs one exponential per spring).
 */
class PALPATE_EXPORT ShapeFriction
{
public:
  static constexpr std::size_t Cells = 16;
  static constexpr std::size_t PerCell = 4;

  explicit ShapeFriction(const FrictionSettings& settings) noexcept;
  void reset() noexcept;
  /// Takes the springs of another contact; `turned` changes a displacement of its frame into one
  /// of this frame.
  template <class Turned>
  void assume(const ShapeFriction& other, const Turned& turned) noexcept
  {
    // A smaller c makes the springs stiffer: they keep their force.
    const double share = std::min(this->Compliance / other.Compliance, 1.0);
    this->Count = other.Count;
    this->Stiffness = other.Stiffness;
    for (std::size_t j = 0; j < other.Count; ++j)
    {
      this->Displacement[j] = share * turned(other.Displacement[j]);
    }
  }

  /// Returns a force of at most μ normalForce, N. `curve` is the response at this contact:
  /// evaluate(depth) -> ResponseValue, range() -> mm.
  template <class Curve>
  TangentialForce update(
    const Vector2& displacement, double normalForce, double deflection, const Curve& curve) noexcept
  {
    return this->move(displacement, springsOf(curve, normalForce, deflection), deflection);
  }

private:
  struct Springs
  {
    std::size_t count = 0;
    std::array<double, Cells * PerCell> stiffness; ///< normal, N/mm
    std::array<double, Cells * PerCell> level;     ///< depth at which the spring touches, mm
  };

  template <class Curve>
  static Springs springsOf(const Curve& curve, double normalForce, double deflection) noexcept
  {
    Springs springs;
    const double range = curve.range();
    const double deepest = std::min(deflection, range);
    double load = 0.0;
    double from = 0.0;
    ResponseValue before;
    for (std::size_t j = 0; j < Cells && from < deepest; ++j)
    {
      const double share = static_cast<double>(j + 1) / static_cast<double>(Cells);
      const double to = j + 1 < Cells ? std::min(range * (share * share), deepest) : deepest;
      const ResponseValue value = curve.evaluate(to);
      const double stiffness = std::max(value.stiffness - before.stiffness, 0.0);
      const double moment =
        (to * value.stiffness - value.force) - (from * before.stiffness - before.force);
      const double centre = stiffness > 0.0 ? std::clamp(moment / stiffness, from, to) : from;
      const double spacing = 2.0 * std::min(centre - from, to - centre) / PerCell;
      load += stiffness * (deflection - centre);
      for (std::size_t i = 0; i < PerCell; ++i)
      {
        springs.stiffness[springs.count] = stiffness / PerCell;
        springs.level[springs.count] =
          centre + spacing * (static_cast<double>(i) - 0.5 * (PerCell - 1));
        ++springs.count;
      }
      before = value;
      from = to;
    }
    const double scale = normalForce / load;
    if (!(scale > 0.0) || !std::isfinite(scale) || !std::isfinite(load))
    {
      return {}; // no force, or the response is zero
    }
    for (std::size_t j = 0; j < springs.count; ++j)
    {
      springs.stiffness[j] *= scale;
      if (!std::isfinite(springs.stiffness[j]))
      {
        return {}; // the contact is so shallow that its stiffness overflows
      }
    }
    return springs;
  }

  TangentialForce move(
    const Vector2& displacement, const Springs& springs, double deflection) noexcept;

  double Coefficient;
  double Compliance; ///< c, tangential over normal
  std::size_t Count = 0;
  std::array<double, Cells * PerCell> Stiffness;
  std::array<Vector2, Cells * PerCell> Displacement;
};

/**
 * Friction of one contact: a tangential force from the pre-sliding displacement of the contact
 * point over the undeformed surface (Mahvash and Hayward 2002, section 3). It does not change the
 * normal force.
 *
 * The displacement is a vector in the tangent plane and is carried over curved bodies by parallel
 * transport (FrictionFrame). FrictionSettings::model selects the force that it causes. All three
 * models depend on the path, not on time or on the number of ticks. Their force never exceeds
 * Coulomb's limit μ f_n.
 *
 * Energy: after the first contact, the work against friction along the displacements over the
 * surface is never negative, however point, depth, normal force and response change (for short
 * ticks; a servo loop that keeps the force constant for a period gains energy, as with any spring).
 * The tip itself, at depth δ under a surface of curvature κ, moves 1 - δκ times as far.
 *
 * One Friction object is one history. It uses no heap memory; update() neither throws nor blocks.
 *
 * Cost of an update: 40 ns (stuck) to 70 ns (sliding under a changing load) with ElastoPlastic and
 * Dahl, 0.5 to 2.5 µs with ShapeDerived; none with coefficient 0.
 */
class PALPATE_EXPORT Friction
{
public:
  /// Settings out of range result in no friction.
  explicit Friction(const FrictionSettings& settings) noexcept;

  /// Ends the contact: the next one starts without pre-sliding displacement.
  void reset() noexcept;

  /// Takes the pre-sliding displacement of another contact that this one continues, at the same
  /// place with other settings or another response: the friction continues, within the limit of
  /// this contact. No energy is created, because a stiffer spring keeps its force and a softer one
  /// its displacement, and a displacement across the tangent plane is lost. No effect unless both
  /// contacts have begun and both have friction, of ShapeDerived or of the two other models.
  void assume(const Friction& other) noexcept;

  /// Result of one tick.
  struct Result
  {
    Vector3 force = Vector3::Zero(); ///< on the tool, tangential, N
    bool sliding = true;             ///< Coulomb's limit is reached; else the contact sticks
  };

  /// Adds the contact of this tick: the point on the undeformed surface, mm; the unit outward
  /// normal; the normal force, N; the depth δ, mm; and the response at the point, with
  /// evaluate(depth) -> ResponseValue and range() -> mm (only used by ShapeDerived). The first call
  /// after reset() results in no force. Values that are not finite, or a normal without unit
  /// length, result in no force and end the history.
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
  static constexpr double UnitTolerance = 1e-3; ///< tolerance of the squared length of a normal

  FrictionModel Model;
  bool Enabled;
  double Coefficient;
  FrictionFrame Frame;
  ElastoPlasticFriction ElastoPlastic;
  DahlFriction Dahl;
  ShapeFriction Shape;
};

/// Whether the values are those of a valid contact.
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
