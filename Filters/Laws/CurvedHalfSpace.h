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
 * The contact of one tool on a curved half-space (CurvedContact.h) at given depths. It needs no
 * separate nodes for each curvature.
 *
 * Two functions are tabulated once per tool, as cubic polynomials of t = √depth: the contact radius
 * a and F/(a t²). For spheres, cones and flat ends they are smooth functions of t. On a body with
 * curvatures κ₁ and κ₂ the depth at the same contact radius is y(t) = √((t² + κ₁a²)(t² + κ₂a²)).
 * Newton's method solves this equation for t. The force is then F + 4/3 a (y - t²) and the
 * stiffness is 2a, both multiplied by 1 + ln²(B/A)/48. For a flat end in full contact both
 * curvatures are replaced by the mean curvature. Error: 1e-7, or 1e-4 near the kinks of a profile.
 * Cost: 40 ns per depth. Can be used from any number of threads.
 */
class PALPATE_EXPORT CurvedHalfSpace
{
public:
  /// Creates the tables of a tool that is pressed to at most the depth `deepest` (mm) into the flat
  /// body.
  CurvedHalfSpace(const AxisymmetricTool& tool, double deepest);

  /// Computes the states of the local contact at `deflections` (mm), which must be > 0 and
  /// ascending. The contact is in series with a compliance; `softness` is C E* (1/mm), not
  /// negative. Returns false if the tool does not fit into the body at one of the deflections.
  bool solve(const SpotCurvature& around, double softness, const std::vector<double>& deflections,
    LocalState* states) const;

private:
  /// One interval of t. The arrays have the coefficients of a cubic polynomial in the position
  /// within the interval, 0 to 1.
  struct Piece
  {
    std::array<double, 4> radius;
    std::array<double, 4> share; ///< F/(a t²), the second tabulated function
  };
  /// The contact circle of the tool on the flat body.
  struct Circle
  {
    double radius; ///< mm
    double slope;  ///< derivative of the radius with respect to t
    double force;  ///< F/E*, mm²
  };
  Circle at(double t) const;
  /// The curved body at a contact radius: t² plus the sag for each of the two curvatures, the
  /// depth, and the derivative of the depth with respect to t. Depth and derivative are 0 if the
  /// hollow is too narrow for the tool.
  struct Sagging
  {
    double one;
    double other;
    double depth;
    double slope;
  };
  static Sagging saggingAt(double t, const Circle& circle, const SpotCurvature& curvature);
  /// The contact on the curved body at the parameter t = √(depth of the tool on the flat body).
  struct Contact
  {
    LocalState local;
    double slope; ///< derivative of the depth with respect to t
    bool isThere; ///< false if the hollow is too narrow for the tool
  };
  Contact contactAt(double t, const SpotCurvature& curvature) const;
  LocalState sagAlone(double depth, const SpotCurvature& curvature) const;
  LocalState sagInSeries(const SpotCurvature& curvature, double softness, double deflection) const;

  double Step; ///< step of t, √mm
  double FlatRadius;
  std::vector<Piece> Pieces;
  /// Contact radius at the end of the first interval, in which the radius is a power of t.
  double FirstRadius = 0.0;
  /// Exponent of this power; 0 for a flat end, whose radius is not a power of t.
  double FirstPower = 0.0;
};
} // namespace palpate

#endif
