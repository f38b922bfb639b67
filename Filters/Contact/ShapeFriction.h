// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ShapeFriction_h
#define palpate_ShapeFriction_h

#include "Contact/ContactSettings.h"
#include "Contact/FrictionFrame.h"
#include "Mechanics/PalpateExport.h"
#include "Contact/ResponseSampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace palpate
{
/**
 * Friction that follows from the stored response f(δ) itself; of its own it has only μ and ν.
 *
 * Where normal and tangential contact are similar (Jaeger 1998; Ciavarella 1998; for spheres
 * Mindlin 1949), a displacement u at constant depth meets
 *   Q(u) = μ [f(δ) - f(δ - u/(μc))],   c = (2-ν)/(2(1-ν)),
 * and slides from u = μcδ on. As the method of dimensionality reduction has it (Popov and Hess
 * 2015), the contact is a row of springs: f''(η) dη of them touch when the depth passes the level
 * η, a flat's f'(0) at 0. A spring of normal stiffness k has tangential stiffness k/c, carries its
 * own displacement u and slides at |u| = μc(δ - η), where its force is μ times its load. History -
 * loading under a varying depth, reversals (Masing's rule), paths that turn - is in these u, all
 * vectors in the tangent plane.
 *
 * Here the springs of each of the cells between the depths range·(j/Cells)², the last one ending at
 * δ, are `PerCell`. Force and stiffness of the response at the ends of a cell give stiffness and
 * load of its springs, so that all together carry exactly f(δ) at any depth, and slide at exactly
 * μ f_n. Cells are fixed in depth (on a body of one range), so springs keep their history as δ
 * changes:
 * - δ grows: the last cell gets wider and stiffer, then others follow, undisplaced at first;
 * - δ shrinks: limits shrink and displacements with them; springs whose cell is above δ are gone,
 *   and have no force left by then;
 * - beyond the range: no more springs, as the response has its last tangent there; limits grow;
 * - below range/256, where the force is under a thousandth of its largest: one cell.
 *
 * Energy. A spring that gets stiffer keeps its force, not its displacement; one that gets softer
 * keeps its displacement. Either way it loses energy, so that no change of depth, force or response
 * along the way can create any. The price: where the response differs from point to point, a stuck
 * contact that is moved to and fro creeps by that difference.
 *
 * Where a response is not convex (f'' < 0, or measured with noise), cells of falling stiffness have
 * no spring and the others are scaled to carry f_n; so they are if f_n is not the curve's own
 * (ForceForm::Paper).
 *
 * Largest error of Q, of μ f_n, paraboloid / cone (a flat: rounding):
 *   springs      16             32             64            16 cells of 4
 *   at range     1.4e-3/3.6e-3  3.4e-4/9.0e-4  8.5e-5/2.2e-4  9.3e-5/2.2e-4
 *   at range/4   5.5e-3/1.4e-2  1.4e-3/3.6e-3  3.4e-4/9.0e-4  4.5e-4/8.5e-4
 * It falls with the square of their number, however they are shared out. A cell costs an evaluation
 * of the response, a spring a few operations; so 16 cells of 4: below 1e-3, as 8 samples hold the
 * response itself, with a quarter of the evaluations.
 *
 * Cost, besides an evaluation of the response per cell within the depth: 5 to 25 ns per spring
 * (stuck or straight; sliding in a curve, an exponential each).
 */
class PALPATE_EXPORT ShapeFriction
{
public:
  static constexpr std::size_t Cells = 16;
  static constexpr std::size_t PerCell = 4;

  explicit ShapeFriction(const FrictionSettings& settings) noexcept;
  void reset() noexcept;

  /// At most μ normalForce, N. `curve` is the response at this contact: evaluate(depth) ->
  /// ResponseValue, range() -> mm.
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
    std::array<double, Cells * PerCell> level;     ///< depth at which it touches, mm
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
      return {}; // no force, or no response
    }
    for (std::size_t j = 0; j < springs.count; ++j)
    {
      springs.stiffness[j] *= scale;
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
} // namespace palpate

#endif
