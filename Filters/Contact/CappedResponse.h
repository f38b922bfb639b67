// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CappedResponse_h
#define palpate_CappedResponse_h

#include "Mechanics/PalpateExport.h"
#include "Contact/ResponseField.h"

namespace palpate
{
/**
 * Force curve of a contact with limited stiffness, for devices that cannot render a higher
 * stiffness:
 *   F_c(δ) = ∫₀^δ min(dF/dδ, K_max) dδ'.
 * F_c is a function of the deflection alone and has no state, so that a closed cycle of the
 * deflection neither gains nor loses energy. When the contact moves over the surface, F_c changes
 * with F.
 *
 * F_c is lower than F because of the intervals [a, b] in which the stiffness exceeds K_max: each
 * interval reduces the force by F(b) - F(a) - K_max (b - a). The ends of the intervals are searched
 * between fixed nodes √(δ/δ_max) = j/16. One end lies between two nodes if the excess dF/dδ - K_max
 * has different signs at these nodes. Two ends lie between them if the cubic with the values and
 * slopes at the nodes has two changes of sign. This cubic gives the first estimate of an end, and
 * regula falsi (Illinois) refines it. The excess is zero at an end, so that an error ε of the
 * position of the end changes the force only by a term of order ε². For a monotone stiffness, the
 * error of F_c is at most 1e-7 of K_max δ. If the stiffness rises and falls several times between
 * two nodes, an interval can be missed (errors up to 2 % in random samples). The nodes do not
 * depend on δ, so that F_c is continuous in δ to 1e-7 of K_max δ. 1e-7.
 *
 * If the stiffness of the response is known to increase with δ (ResponseField), there is at most
 * one interval, and it has no upper end. There is no interval while dF/dδ <= K_max. The start of
 * the interval is found by bisection over the nodes.
 *
 * Cost: one evaluation of F per node up to δ (16 up to the end of the range, at most 32 beyond it),
 * and about 3 evaluations (at most Refinements) per end of an interval. A monotone stiffness has
 * one end. If the stiffness is known to increase, about 8 evaluations are needed, or none if there
 * is no interval. A negative F_c, which can occur when the stiffness is capped and then negative
 * over a long range, is replaced by 0. If K_max is infinite, F_c equals F. If K_max is negative or
 * NaN, F_c is 0. F_c is also 0 for δ <= 0 and for NaN. The functions neither allocate nor throw.
 */
class PALPATE_EXPORT CappedResponse
{
public:
  static constexpr int NodesInRange = 16;
  static constexpr int Nodes = 2 * NodesInRange;
  static constexpr int Refinements = 12;

  /// `maximumStiffness` is K_max, N/mm.
  CappedResponse(const BlendedResponse& response, double maximumStiffness) noexcept
    : Response(response)
    , Maximum(maximumStiffness > 0.0 ? maximumStiffness : 0.0)
    , Range(response.range())
  {
  }

  /// Returns F_c and the stiffness min(dF/dδ, K_max).
  ResponseValue evaluate(double deflection) const noexcept;
  /// Returns F_c/F, 0 to 1. The whole force of the contact, including friction, is to be multiplied
  /// by this fraction.
  double share(double deflection) const noexcept;

private:
  struct Place
  {
    double root = 0.0;       ///< √(δ/δ_max)
    double deflection = 0.0; ///< mm
    double force = 0.0;      ///< N
    double excess = 0.0;     ///< dF/dδ - K_max, N/mm
  };

  /// The parabola first + second t + third t² over 0 <= t <= 1.
  struct Slope
  {
    double first;
    double second;
    double third;

    /// Returns the position t of the zero, if the values at t = 0 and t = 1 have different signs.
    double root() const noexcept;
    /// Returns the position t of an extremum whose sign differs from that of both end values; 0 if
    /// there is no such extremum.
    double oppositeExtreme() const noexcept;
  };

  Place at(double root) const noexcept;
  Place atOnset(const Place& first) const noexcept;
  Slope slopeBetween(const Place& low, const Place& high) const noexcept;
  /// Returns the point at which the excess is zero, between two points whose excess has different
  /// signs.
  Place crossing(Place low, Place high) const noexcept;
  /// Applies the limit to F and dF/dδ (`value`) at a deflection.
  ResponseValue cap(double deflection, ResponseValue value) const noexcept;
  /// Returns the force by which the limit of the stiffness reduces F at δ > 0, N.
  double lost(double deflection, double force) const noexcept;
  /// As lost(), for a stiffness that only increases and exceeds K_max at δ.
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
