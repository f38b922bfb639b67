// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CurvedHalfSpace_h
#define palpate_CurvedHalfSpace_h

#include "Laws/ContactSpot.h"
#include "Laws/CurvedContact.h"
#include "Mechanics/PalpateExport.h"

#include <array>
#include <vector>

namespace palpate
{
class AxisymmetricTool;

/**
 * The contact of one tool on a curved half-space (CurvedContact.h) at given depths, without nodes
 * for each curvature.
 *
 * Of the tool alone, once: contact radius a, and force F over a t², over t = √depth, as cubic
 * polynomials, in which spheres, cones and flats are smooth. On a body of curvatures κ₁, κ₂ the
 * depth of the same circle is y(t) = √((t² + κ₁a²)(t² + κ₂a²)), solved for t by Newton's method;
 * the force is F + 4/3 a (y - t²), the stiffness 2a, both times 1 + ln²(B/A)/48. A flat end that is
 * touched whole has the mean curvature for both. Errs by 1e-7, and by 1e-4 near the kinks of a
 * profile. Cost: 40 ns a depth. Safe to use from any number of threads.
 */
class PALPATE_EXPORT CurvedHalfSpace
{
public:
  /// The tool pressed `deepest` (mm) into the flat body at most.
  CurvedHalfSpace(const AxisymmetricTool& tool, double deepest);

  /// The contact at `deflections` (mm), which ascend from above 0, in series with a compliance of
  /// `softness` = C E* (1/mm), not negative: the states are those of the local part. False where
  /// the tool does not fit into the body down to the last of them.
  bool solve(const SpotCurvature& around, double softness, const std::vector<double>& deflections,
    LocalState* states) const;

private:
  /// Of one interval of t, coefficients of the powers of the fraction of it that is passed.
  struct Piece
  {
    std::array<double, 4> radius;
    std::array<double, 4> share; ///< F/(a t²)
  };
  /// The tool on the flat body.
  struct Circle
  {
    double radius; ///< mm
    double slope;  ///< of the radius over t
    double force;  ///< F/E*, mm²
  };
  Circle at(double t) const;
  /// The curved body under a circle: the two sums of t² and the sag, the depth, and its slope over
  /// t; 0 where the body's hollow is narrower.
  struct Sagging
  {
    double one;
    double other;
    double depth;
    double slope;
  };
  static Sagging saggingAt(double t, const Circle& circle, const SpotCurvature& curvature);
  /// The contact on the curved body with the circle of t.
  struct Contact
  {
    LocalState local;
    double slope; ///< of its depth over t
    bool isThere; ///< false: the body's hollow is narrower
  };
  Contact contactAt(double t, const SpotCurvature& curvature) const;
  LocalState sagAlone(double depth, const SpotCurvature& curvature) const;
  LocalState sagInSeries(const SpotCurvature& curvature, double softness, double deflection) const;

  double Step; ///< of t, √mm
  double FlatRadius;
  std::vector<Piece> Pieces;
  double FirstRadius = 0.0; ///< at the end of the first piece, in which it is a power of t;
  double FirstPower = 0.0;  ///< 0: it is not, of a flat end
};
} // namespace palpate

#endif
