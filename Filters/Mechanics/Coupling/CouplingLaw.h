// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CouplingLaw_h
#define palpate_CouplingLaw_h

#include "Mechanics/Layers/LayerKernel.h"
#include "Mechanics/PalpateExport.h"

#include <vector>

namespace palpate
{
/// A knot of the coupling law of a layer, at x/(1 + x) = k / CouplingLaw::Places with the index k.
struct CouplingKnot
{
  double share = 1.0; ///< g at x = r/h
  double slope = 0.0; ///< derivative of g with respect to x/(1 + x)
  double ratio = 0.0; ///< a/h of a contact whose stiffness is 2E*h x
};

/**
 * The compliance of a body at one point of its surface under a force at another point, at a
 * distance r: C(r) = g / (πE* r). On a half-space g = 1 (Boussinesq). In Fourier space the
 * displacement of the surface of a layer of thickness h is W(kh) times that of a half-space
 * (LayerKernel). Therefore
 *   g(x) = 1 + x ∫_0^∞ (W(ω) - 1) J₀(ωx) dω = 1 + (2x/π) ∫_0^{π/2} M(x sin φ) dφ, x = r/h.
 * If the base is rigid, g is negative beyond about one thickness, where the surface bulges, and
 * decays to 0 at a slightly larger distance.
 *
 * g is stored as cubic polynomials between 79 knots, with an error of 2e-6; for x > 39 it is
 * constant. The law also gives the contact radius a for a stiffness K, for any tool whose pressure
 * vanishes at the rim. On a half-space K = 2E* a. Immutable; can be used from any number of
 * threads.
 */
class PALPATE_EXPORT CouplingLaw
{
public:
  static constexpr int KnotCount = 79;
  static constexpr double Places = 80.0;

  /// Creates the law of a half-space.
  CouplingLaw() = default;
  /// Creates the law of a layer or of a stack; h and E* are those of the top layer. Takes about 10
  /// ms.
  explicit CouplingLaw(const LayerKernel& kernel);
  /// Creates a law from the KnotCount knots of another law, or the law of a half-space if there are
  /// no knots.
  explicit CouplingLaw(std::vector<CouplingKnot> knots)
    : Knots(std::move(knots))
  {
  }

  bool isLayered() const noexcept { return !this->Knots.empty(); }
  const std::vector<CouplingKnot>& knots() const noexcept { return this->Knots; }

  /// g and its derivative with respect to x = r/h, x >= 0.
  struct Share
  {
    double value;
    double slope;
  };
  Share at(double x) const noexcept;

  /// Returns the radius (mm) of a contact with the stiffness `stiffness` (N/mm). `modulus` is E*
  /// (MPa), `thickness` h (mm); both > 0.
  double contactRadius(double stiffness, double modulus, double thickness) const noexcept;

private:
  std::vector<CouplingKnot> Knots;
};
} // namespace palpate

#endif
