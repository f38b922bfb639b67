// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CouplingLaw_h
#define palpate_CouplingLaw_h

#include "Mechanics/Layers/LayerKernel.h"
#include "Mechanics/PalpateExport.h"

#include <vector>

namespace palpate
{
/// Where the law of a layer is kept: at place k of x/(1 + x) = k / CouplingLaw::Places.
struct CouplingKnot
{
  double share = 1.0; ///< g at x = r/h
  double slope = 0.0; ///< its derivative by x/(1 + x)
  double ratio = 0.0; ///< a/h of a contact of stiffness 2E*h x
};

/**
 * How far a body gives way at one place under a force at another, r away:
 *   C(r) = g / (πE* r), on a half-space g = 1 (Boussinesq),
 *   on a layer of thickness h, whose surface moves by W(kh) of a half-space's (LayerKernel),
 *   g(x) = 1 + x ∫_0^∞ (W(ω) - 1) J₀(ωx) dω = 1 + (2x/π) ∫_0^{π/2} M(x sin φ) dφ, x = r/h.
 * On a rigid base g is negative beyond about one thickness, where the surface bulges, and soon 0.
 *
 * Cubic polynomials between 79 knots, within 2e-6 of g; beyond x = 39 g stays. Also the contact
 * radius a of a stiffness, of any tool whose pressure ends smoothly: on a half-space K = 2E* a.
 * Immutable and safe to use from any number of threads.
 */
class PALPATE_EXPORT CouplingLaw
{
public:
  static constexpr int KnotCount = 79;
  static constexpr double Places = 80.0;

  /// Of a half-space.
  CouplingLaw() = default;
  /// Of a layer, or a stack of them, whose h and E* are those of the top layer. About 10 ms.
  explicit CouplingLaw(const LayerKernel& kernel);
  /// KnotCount knots that another has told, or none.
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

  /// Of a contact of this stiffness (N/mm), mm; `modulus` E*, MPa, and `thickness` h, mm, > 0.
  double contactRadius(double stiffness, double modulus, double thickness) const noexcept;

private:
  std::vector<CouplingKnot> Knots;
};
} // namespace palpate

#endif
