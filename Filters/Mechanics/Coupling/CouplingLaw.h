// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CouplingLaw_h
#define palpate_CouplingLaw_h

#include "Mechanics/Layers/LayerKernel.h"
#include "Mechanics/PalpateExport.h"

#include <vector>

namespace palpate
{
/// A knot of a layer's law, at x/(1 + x) = k / CouplingLaw::Places.
struct CouplingKnot
{
  double share = 1.0; ///< g at x = r/h
  double slope = 0.0; ///< its derivative by x/(1 + x)
  double ratio = 0.0; ///< a/h of a contact of stiffness 2E*h x
};

/**
 * The compliance of a body at one place under a force at another at distance r: C(r) = g / (πE* r).
 * On a half-space g = 1 (Boussinesq). On a layer of thickness h, whose surface moves by W(kh) times
 * that of a half-space (LayerKernel),
 *   g(x) = 1 + x ∫_0^∞ (W(ω) - 1) J₀(ωx) dω = 1 + (2x/π) ∫_0^{π/2} M(x sin φ) dφ, x = r/h.
 * On a rigid base g is negative beyond about one thickness, where the surface bulges, and decays to
 * 0 soon after.
 *
 * Cubic polynomials between 79 knots, within 2e-6 of g; beyond x = 39 g is constant. Also the
 * contact radius a for a stiffness K, for any tool whose pressure vanishes at the rim: on a
 * half-space K = 2E* a. Immutable and safe to use from any number of threads.
 */
class PALPATE_EXPORT CouplingLaw
{
public:
  static constexpr int KnotCount = 79;
  static constexpr double Places = 80.0;

  /// Of a half-space.
  CouplingLaw() = default;
  /// Of a layer, or of a stack; h and E* are those of the top layer. About 10 ms.
  explicit CouplingLaw(const LayerKernel& kernel);
  /// KnotCount knots of another law, or none.
  explicit CouplingLaw(std::vector<CouplingKnot> knots)
    : Knots(std::move(knots))
  {
  }

  bool isLayered() const noexcept { return !this->Knots.empty(); }
  const std::vector<CouplingKnot>& knots() const noexcept { return this->Knots; }

  /// g, and its derivative by x = r/h >= 0.
  struct Share
  {
    double value;
    double slope;
  };
  Share at(double x) const noexcept;

  /// Radius of a contact of this stiffness (N/mm), mm; `modulus` E*, MPa, and `thickness` h,
  /// mm, > 0.
  double contactRadius(double stiffness, double modulus, double thickness) const noexcept;

private:
  std::vector<CouplingKnot> Knots;
};
} // namespace palpate

#endif
