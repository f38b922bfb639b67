// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CappedResponse_h
#define palpate_CappedResponse_h

#include "Mechanics/PalpateExport.h"
#include "Contact/ResponseField.h"

namespace palpate
{
/**
 * The curve of a contact with its stiffness capped, for devices that cannot render a stiffer one:
 *   F_c(δ) = ∫₀^δ min(dF/dδ, K_max) dδ'.
 * A function of the deflection alone: it has no state, takes no energy and gives none, and moves
 * with the contact as F does.
 *
 * F_c = F but for the stretches [a, b] where the stiffness is above K_max: each takes away
 * F(b) - F(a) - K_max (b - a). Their ends are sought between fixed nodes √(δ/δ_max) = j/16: where
 * the excess dF/dδ - K_max changes its sign, and where the cubic with the values and slopes at two
 * nodes shows that it does so twice between them. An end is first taken from that cubic, then found
 * by regula falsi (Illinois); the excess is zero there, so an error ε of its place counts with ε²
 * only. Of a monotone stiffness F_c is right to 1e-7 of K_max δ; where the stiffness goes up and
 * down several times between two nodes a stretch can be missed (random samples: up to 2 %). The
 * nodes do not depend on δ, so F_c is continuous in it but for that 1e-7.
 *
 * Where the response is known to have a stiffness that only rises (ResponseField), there is one
 * stretch at most, without an end above: none while dF/dδ <= K_max, and where it begins is sought
 * by halving the nodes.
 *
 * Cost: an evaluation of F per node up to δ, 16 to the end of the range (beyond, at most 32), and
 * about 3 (at most Refinements) per end of a stretch, of which a monotone stiffness has one. Of a
 * stiffness known to rise, none where there is no stretch, else about 8. F_c
 * below 0, after a capped rise and a longer fall, is 0. K_max infinite: F; negative or NaN: 0.
 * δ <= 0 and NaN give 0. Neither allocates nor throws.
 */
class PALPATE_EXPORT CappedResponse
{
public:
  static constexpr int NodesInRange = 16;
  static constexpr int Nodes = 2 * NodesInRange;
  static constexpr int Refinements = 12;

  /// `maximumStiffness` in N/mm.
  CappedResponse(const BlendedResponse& response, double maximumStiffness) noexcept
    : Response(response)
    , Maximum(maximumStiffness > 0.0 ? maximumStiffness : 0.0)
    , Range(response.range())
  {
  }

  /// F_c and min(dF/dδ, K_max).
  ResponseValue evaluate(double deflection) const noexcept;
  /// F_c/F, 0 to 1: of the whole force of a contact, friction included, so much may stay.
  double share(double deflection) const noexcept;

private:
  struct Place
  {
    double root = 0.0;       ///< √(δ/δ_max)
    double deflection = 0.0; ///< mm
    double force = 0.0;      ///< N
    double excess = 0.0;     ///< dF/dδ - K_max, N/mm
  };

  /// A parabola over [0, 1].
  struct Slope
  {
    double first;
    double second;
    double third;

    /// Where it is zero, if its ends have different signs.
    double root() const noexcept;
    /// Where it has an extreme of the other sign than both its ends; 0 if it has not.
    double oppositeExtreme() const noexcept;
  };

  Place at(double root) const noexcept;
  Place atOnset(const Place& first) const noexcept;
  Slope slopeBetween(const Place& low, const Place& high) const noexcept;
  /// Between two places whose excess has different signs, where it has none.
  Place crossing(Place low, Place high) const noexcept;
  /// F and dF/dδ at a deflection, capped.
  ResponseValue cap(double deflection, ResponseValue value) const noexcept;
  /// What the cap has taken from F at δ > 0.
  double lost(double deflection, double force) const noexcept;
  /// The same of a stiffness that only rises, and is above K_max at δ.
  double lostByRise(double deflection, double force) const noexcept;
  double taken(const Place& from, double end, double forceThere) const noexcept
  {
    return forceThere - from.force - this->Maximum * (end - from.deflection);
  }

  BlendedResponse Response;
  double Maximum;
  double Range;
};
} // namespace palpate

#endif
