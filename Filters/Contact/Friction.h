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
 * Dahl's friction (1968), used as the baseline of the studies: dz = dx - |dx| z/z_max, with the
 * force -σ₀ z and z_max = limit/σ₀. The model creeps under any displacement, however small. Under a
 * load that varies between z₁ and z₂ (in units of z_max) within the limit, it therefore drifts by
 * z_max [ln((1-z₁)/(1-z₂)) - ln((1+z₂)/(1+z₁))] per cycle.
 *
 * Along a straight step of length y and direction d the equation is linear and has the exact
 * solution
 *   z e^(-y/z_max) + z_max (1 - e^(-y/z_max)) d.
 * Therefore the result does not depend on the number of ticks on a path. The explicit step of
 * Hayward and Armstrong 2000 would slide at z_max - |dx|, so that its force depends on the speed.
 *
 * The force approaches the limit but never reaches it. A contact counts as sliding from 99 % of the
 * limit. On a circle of radius ρ the force lags by atan(z_max/ρ), and its magnitude is the limit
 * times the cosine of that angle.
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
 * Elasto-plastic friction of Hayward and Armstrong 2000, with the states stick, creep and slide.
 *
 * The displacement x of the contact point over the surface is the sum of an elastic part z and a
 * plastic part w. The force is -σ₀ z. If dx has a positive component along z, a part of the
 * displacement is plastic:
 *   dw = α(|z|) z (dx·z/|z|),   and |z| <= z_max = limit/σ₀.
 * If dx is directed against z, the displacement is elastic, so that a contact unloads elastically
 * (Dupont, Hayward, Armstrong and Altpeter 2002). Let r = |z|/z_max, and let b = breakaway and s =
 * stick radius be given in units of z_max. Then
 *   α z_max = w/(w + s⁸ - b⁸),   w = max(r⁸ - b⁸, 0).
 * b = 0 gives α = z⁸/(z_st⁸ + z⁸)/z_max, as in Hayward and Armstrong; b = s = 1 gives their
 * stick-slip model.
 *
 * Reason for b > 0: even a small α causes drift. Under 0.1 kg and a load of 0.5 ± 0.2 of the limit
 * at 2 Hz, the z⁸ law creeps by 6 µm per cycle at s = 0.9 and by 0.2 mm at s = 0.5 (z_max = 1 mm),
 * without end. A contact does not drift only if α is exactly 0 in a neighbourhood of z = 0 (proof:
 * Dupont et al.).
 *
 * Only the displacement along z counts. With |dx| instead, the contact would unload more stiffly
 * than σ₀ (up to 2 σ₀, which can exceed the stability limit of the loop), and z would also shrink
 * under displacements across z. At the limit the model is Coulomb's law with the force against the
 * sliding direction.
 *
 * A step of any length has three parts in this order: elastic motion to the breakaway circle,
 * creep, and the tractrix at the limit. The elastic motion and the tractrix are exact. Creep is
 * integrated by the fourth-order Runge-Kutta method in at most 40 pieces of at most 1/8 z_max
 * (error below 2e-5 of the limit). On a circle of radius ρ > z_max the force is at the limit and
 * lags by asin(z_max/ρ).
 *
 * σ₀ is constant and |z| is clipped. Therefore a changing normal force dissipates energy but never
 * creates it (a stiffness σ₀ = limit/z_max would create ½ z² Δσ₀ per cycle).
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
  /// Handles a step in which the contact only slides. For other steps, returns false and changes
  /// nothing.
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
 * Friction computed from the stored response f(δ). Its only parameters are μ and ν.
 *
 * The normal and the tangential contact problem are similar (Jaeger 1998; Ciavarella 1998; for
 * spheres Mindlin 1949). A displacement u at constant depth therefore causes the force
 *   Q(u) = μ [f(δ) - f(δ - u/(μc))],   c = (2-ν)/(2(1-ν)),
 * and the contact slides for u >= μcδ. In the method of dimensionality reduction (Popov and Hess
 * 2015) the contact is a row of springs. Springs of stiffness f''(η) dη touch when the depth passes
 * the level η. For a flat end, springs of stiffness f'(0) touch at level 0. A spring of normal
 * stiffness k has the tangential stiffness k/c and its own displacement u. It slides when |u| =
 * μc(δ - η), where its force is μ times its load. The displacements u, which are vectors in the
 * tangent plane, store the history: loading under a varying depth, reversals by Masing's rule, and
 * curved paths.
 *
 * The depths range·(j/Cells)² divide the depth into cells; the last cell ends at δ. Each cell has
 * `PerCell` springs. The stiffness and load of the springs of a cell follow from the force and
 * stiffness of the response at both ends of the cell. Therefore all springs together carry exactly
 * f(δ) at any depth, and slide at exactly μ f_n. Cells are fixed in depth (on a body with one
 * range), so that springs keep their history as δ changes:
 * - δ grows: the last cell gets wider and stiffer, then further cells are added, initially without
 *   displacement;
 * - δ decreases: the limits and therefore the displacements decrease; springs whose cell is above δ
 *   have lost their force and are removed;
 * - beyond the range: no further springs are added, because the response continues along its last
 *   tangent; the limits grow;
 * - below range/256, where the force is less than a thousandth of its largest value: there is only
 *   one cell.
 *
 * Energy: a spring that gets stiffer keeps its force, not its displacement. A spring that gets
 * softer keeps its displacement. In both cases energy is lost, so that no change of depth, force or
 * response along the path can create energy. The disadvantage is a creep on bodies whose response
 * differs from point to point: a stuck contact that is moved back and forth creeps by that
 * difference.
 *
 * Cells of falling stiffness (f'' < 0, for a response that is not convex or was measured with
 * noise) have no spring, and the other springs are scaled to carry f_n. The springs are also scaled
 * if f_n is not the force of the curve (ForceForm::Paper).
 *
 * Largest error of Q, divided by μ f_n, for paraboloid / cone (for a flat end there is only
 * rounding error):
 *   springs      16             32             64            16 cells of 4
 *   at range     1.4e-3/3.6e-3  3.4e-4/9.0e-4  8.5e-5/2.2e-4  9.3e-5/2.2e-4
 *   at range/4   5.5e-3/1.4e-2  1.4e-3/3.6e-3  3.4e-4/9.0e-4  4.5e-4/8.5e-4
 * The error is inversely proportional to the square of the number of springs, however they are
 * distributed over cells. A cell costs an evaluation of the response, a spring only a few
 * operations. Therefore 16 cells of 4 springs are used: their error is below 1e-3, similar to the
 * error of 8 samples of the response, with a quarter of the evaluations of 64 cells.
 *
 * Cost, in addition to one evaluation of the response per cell within the depth: 5 to 25 ns per
 * spring. A spring that sticks or slides along a straight path is cheap; sliding on a curve needs
 * one exponential per spring.
 */
class PALPATE_EXPORT ShapeFriction
{
public:
  static constexpr std::size_t Cells = 16;
  static constexpr std::size_t PerCell = 4;

  explicit ShapeFriction(const FrictionSettings& settings) noexcept;
  void reset() noexcept;
  /// Takes over the springs of another contact. `turned` converts a displacement from the frame of
  /// the other contact to this frame.
  template <class Turned>
  void assume(const ShapeFriction& other, const Turned& turned) noexcept
  {
    // A smaller c makes the springs stiffer; then they keep their force.
    const double share = std::min(this->Compliance / other.Compliance, 1.0);
    this->Count = other.Count;
    this->Stiffness = other.Stiffness;
    for (std::size_t j = 0; j < other.Count; ++j)
    {
      this->Displacement[j] = share * turned(other.Displacement[j]);
    }
  }

  /// Returns a force of at most μ normalForce, N. `curve` is the response at this contact. Its
  /// function evaluate(depth) returns a ResponseValue, range() the range in mm.
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
    std::array<double, Cells * PerCell> stiffness; ///< normal stiffness of the spring, N/mm
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
      return {}; // there is no force, or the response is zero
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
  double Compliance; ///< c, tangential compliance divided by normal compliance
  std::size_t Count = 0;
  std::array<double, Cells * PerCell> Stiffness;
  std::array<Vector2, Cells * PerCell> Displacement;
};

/**
 * Friction of one contact. The tangential force depends on the pre-sliding displacement of the
 * contact point over the undeformed surface (Mahvash and Hayward 2002, section 3). It does not
 * change the normal force.
 *
 * The displacement is a vector in the tangent plane and is carried over curved bodies by parallel
 * transport (FrictionFrame). FrictionSettings::model selects the force law. All three laws depend
 * on the path, not on time or on the number of ticks. Their force never exceeds Coulomb's limit μ
 * f_n.
 *
 * Energy: after the first contact, the work against friction along the displacements over the
 * surface is never negative, however point, depth, normal force and response change. This applies
 * to short ticks; a servo loop that keeps the force constant for a period gains energy, as with any
 * spring. The tip itself, at depth δ under a surface of curvature κ, moves 1 - δκ times as far as
 * the contact point.
 *
 * One Friction object stores the history of one contact. It uses no heap memory; update() neither
 * throws nor blocks.
 *
 * Cost of an update: 40 ns (stuck) to 70 ns (sliding under a changing load) with ElastoPlastic and
 * Dahl, 0.5 to 2.5 µs with ShapeDerived. With coefficient 0 there is no cost.
 */
class PALPATE_EXPORT Friction
{
public:
  /// If the settings are out of range, the contact has no friction.
  explicit Friction(const FrictionSettings& settings) noexcept;

  /// Ends the contact. The next contact starts without pre-sliding displacement.
  void reset() noexcept;

  /// Takes over the pre-sliding displacement of another contact at the same point, which has other
  /// settings or another response. The friction then continues within the limit of this contact. No
  /// energy is created: a stiffer spring keeps its force, a softer one its displacement, and a
  /// displacement across the tangent plane is lost. Has no effect unless both contacts have begun
  /// and have friction, and both or neither of them use ShapeDerived.
  void assume(const Friction& other) noexcept;

  /// Result of one tick.
  struct Result
  {
    Vector3 force = Vector3::Zero(); ///< tangential force on the tool, N
    bool sliding = true; ///< whether Coulomb's limit is reached; otherwise the contact sticks
  };

  /// Adds the contact of this tick and returns its friction. `contactPoint` is the point on the
  /// undeformed surface, mm. `normal` is the unit outward normal. `normalForce` is in N, the depth
  /// `deflection` in mm. `curve` is the response at the point, with evaluate(depth) ->
  /// ResponseValue and range() -> mm; only ShapeDerived uses it. The first call after reset()
  /// results in no force. Values that are not finite, or a normal without unit length, result in no
  /// force and end the history.
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
  /// Tolerance of the squared length of a unit normal.
  static constexpr double UnitTolerance = 1e-3;

  FrictionModel Model;
  bool Enabled;
  double Coefficient;
  FrictionFrame Frame;
  ElastoPlasticFriction ElastoPlastic;
  DahlFriction Dahl;
  ShapeFriction Shape;
};

/// Moves the frame to the contact of this tick. Returns false if the values are not those of a
/// valid contact.
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
