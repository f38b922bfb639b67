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
 * F_c is a function of the deflection alone: it has no state, and a closed cycle of the deflection
 * neither gains nor loses energy. As the contact moves over the surface, F_c changes as F does.
 *
 * F_c is lower than F because of the intervals [a, b] in which the stiffness is above K_max: each
 * reduces the force by F(b) - F(a) - K_max (b - a). The ends of the intervals are searched between
 * fixed nodes √(δ/δ_max) = j/16. One end lies between two nodes if the excess dF/dδ - K_max has
 * different signs at these nodes. Two ends lie between them if the cubic with the values and slopes
 * at the nodes has two changes of sign. This cubic gives the first guess of an end; regula falsi
 * (Illinois) then refines it. The excess is zero at an end, so that an error ε of its position
 * changes the force only by the order of ε². For a monotone stiffness F_c is exact to 1e-7 of K_max
 * δ. If the stiffness rises and falls several times between two nodes, an interval can be missed
 * (random samples: up to 2 %). The nodes do not depend on δ, so that F_c is continuous in δ to that
 * 1e-7.
 *
 * If the stiffness of the response is known to rise (ResponseField), there is at most one interval,
 * without an upper end. There is none while dF/dδ <= K_max; its start is found by bisection of the
 * nodes.
 *
 * Cost: one evaluation of F per node up to δ, that is 16 up to the end of the range and at most 32
 * beyond it, and about 3 (at most Refinements) per end of an interval; a monotone stiffness has one
 * end. For a stiffness known to rise, no evaluation if there is no interval, else about 8. A
 * negative F_c, which can follow a capped rise and a longer fall, is replaced by 0. If K_max is
 * infinite, F_c is F; if K_max is negative or NaN, F_c is 0. F_c is 0 for δ <= 0 and NaN. No
 * function allocates or throws.
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
  /// F_c/F, 0 to 1: the fraction of the whole force of a contact, friction included, that may
  /// remain.
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

    /// Position of the zero, if the values at 0 and 1 have different signs.
    double root() const noexcept;
    /// Position of an extremum with the opposite sign of both end values; 0 if there is none.
    double oppositeExtreme() const noexcept;
  };

  Place at(double root) const noexcept;
  Place atOnset(const Place& first) const noexcept;
  Slope slopeBetween(const Place& low, const Place& high) const noexcept;
  /// The place without excess between two places whose excess has different signs.
  Place crossing(Place low, Place high) const noexcept;
  /// F and dF/dδ at a deflection, capped.
  ResponseValue cap(double deflection, ResponseValue value) const noexcept;
  /// The force by which the cap reduces F at δ > 0, N.
  double lost(double deflection, double force) const noexcept;
  /// lost() for a stiffness that only rises and is above K_max at δ.
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
