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
 * Tabulated once for the tool: contact radius a and F/(a t²) as cubic polynomials of t = √depth, in
 * which spheres, cones and flats are smooth. On a body of curvatures κ₁, κ₂ the depth of the same
 * circle is y(t) = √((t² + κ₁a²)(t² + κ₂a²)), solved for t by Newton's method; the force is F + 4/3
 * a (y - t²), the stiffness 2a, both times 1 + ln²(B/A)/48. A flat end in full contact has the mean
 * curvature for both. Error 1e-7, 1e-4 near the kinks of a profile. Cost: 40 ns a depth. Safe to
 * use from any number of threads.
 */
class PALPATE_EXPORT CurvedHalfSpace
{
public:
  /// For a tool pressed at most `deepest` (mm) into the flat body.
  CurvedHalfSpace(const AxisymmetricTool& tool, double deepest);

  /// The contact at `deflections` (mm), which ascend from above 0, in series with a compliance of
  /// `softness` = C E* (1/mm), not negative: the states are those of the local part. False where
  /// the tool does not fit into the body down to the last of them.
  bool solve(const SpotCurvature& around, double softness, const std::vector<double>& deflections,
    LocalState* states) const;

private:
  /// On one interval of t, coefficients of the powers of the fraction of the interval.
  struct Piece
  {
    std::array<double, 4> radius;
    std::array<double, 4> share; ///< F/(a t²)
  };
  /// The tool on the flat body.
  struct Circle
  {
    double radius; ///< mm
    double slope;  ///< derivative of the radius by t
    double force;  ///< F/E*, mm²
  };
  Circle at(double t) const;
  /// The curved body under a circle: the two sums of t² and the sag, the depth, and its derivative
  /// by t; 0 where the body's hollow is too narrow.
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
    double slope; ///< derivative of its depth by t
    bool isThere; ///< false: the body's hollow is too narrow
  };
  Contact contactAt(double t, const SpotCurvature& curvature) const;
  LocalState sagAlone(double depth, const SpotCurvature& curvature) const;
  LocalState sagInSeries(const SpotCurvature& curvature, double softness, double deflection) const;

  double Step; ///< of t, √mm
  double FlatRadius;
  std::vector<Piece> Pieces;
  double FirstRadius = 0.0; ///< at the end of the first piece, in which the radius is a power of t;
  double FirstPower = 0.0;  ///< 0: it is not, as for a flat end
};
} // namespace palpate

#endif
