// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_AxisymmetricTool_h
#define palpate_AxisymmetricTool_h

#include "Mechanics/Tools/DepthLimit.h"
#include "Mechanics/IndentationLaw.h"
#include "Mechanics/PalpateExport.h"

#include <string>
#include <vector>

namespace palpate
{
/// Displacement of a point of the body's surface, mm. `radial` is positive away from the axis of
/// the tool, `normal` is positive into the body.
struct SurfaceDisplacement
{
  double radial;
  double normal;
};

/**
 * A rigid, frictionless tool of revolution, and its contact with an elastic half-space.
 *
 * The tool has the profile z = f(r), f(0) = 0, and is pressed to the depth δ. In the method of
 * dimensionality reduction (Galin; Sneddon 1965; Popov and Hess 2015) the reduced profile is
 *   g(x) = x ∫_0^{π/2} f'(x sin θ) dθ,
 * the contact radius a is the solution of g(a) = δ, the force is F = 2E* ∫_0^a (δ - g) dx, and for
 * every profile dF/dδ = 2E* a. Pressure and displacements are also computed from g
 * (DimensionalityReduction.h); shapes with closed forms override them.
 *
 * Units: mm, N, MPa. If there is no contact (δ <= 0), every result is 0. A NaN argument results in
 * NaN. The reduced modulus is E* = E/(1-ν²), see ReducedModulus.h. The laws assume linear
 * elasticity at small strain, see depthAtStrain(). If g is not increasing everywhere, the formulas
 * are not valid at large depths: for depths beyond depthLimit() every result is NaN. Immutable; can
 * be called from any number of threads.
 */
class PALPATE_EXPORT AxisymmetricTool : public IndentationLaw
{
public:
  /// Returns the tool as text in the form used on a command line, "sphere:6.35". No precision is
  /// lost; parseTool() reads this text.
  virtual std::string specification() const = 0;

  /// Returns f(r), mm, the height of the tool's surface above its tip; +inf beyond its outer wall.
  virtual double profile(double r) const = 0;

  /// Returns the exponent m of F ∝ δ^m at small depth. For a sampled profile, whose tip is a
  /// straight segment, it is the exponent half way to its wall.
  virtual double forceExponent() const = 0;

  /// Returns the depth (mm) at which the strain measure a/R exceeds `ratio`; a/R is the contact
  /// radius divided by the tip radius. For tools without a tip radius the measure is δ/a, which
  /// equals a/R for a paraboloid. Returns 0 if the measure exceeds `ratio` at first contact, and
  /// +inf if it never exceeds `ratio`.
  virtual double depthAtStrain(double ratio) const = 0;

  /// Returns g(a), the depth (mm) at which the contact radius is a. Returns 0 if the contact radius
  /// exceeds a at every depth, and +inf if it is less than a at every depth.
  virtual double depthAtContactRadius(double a) const = 0;

  /// Returns g(x), mm, for smallestContactRadius <= x < largestContactRadius; 0 for smaller x.
  virtual double reducedProfile(double x) const = 0;
  /// Returns the contact radius at first contact, mm: the radius of the flat end, or 0.
  virtual double smallestContactRadius() const { return 0.0; }
  /// Returns the upper bound of the contact radius, mm: the radius of the outer wall, or +inf.
  virtual double largestContactRadius() const = 0;
  /// Radii > 0 (mm, ascending) at which g is not analytic, including the smallest contact radius.
  virtual std::vector<double> kinks() const { return {}; }

  /// Returns the depth beyond which the tool would touch the body outside the circle of contact,
  /// and the radius of that second contact.
  virtual DepthLimit depthLimit() const { return {}; }
  /// Returns the reason why the law is not valid at a deflection, with both depths and the radius;
  /// "" if it is valid.
  std::string checkDepth(double deflection) const;

  IndentationPoint evaluate(double deflection, double reducedModulus) const final;
  double contactRadius(double deflection) const;
  double force(double deflection, double reducedModulus) const;
  /// Returns dF/dδ, N/mm.
  double stiffness(double deflection, double reducedModulus) const;
  /// Returns the contact pressure at distance r from the axis, MPa; 0 outside the contact, +inf at
  /// a sharp rim or apex.
  double pressure(double r, double deflection, double reducedModulus) const;
  /// Returns the displacement of the surface point that was at the distance r (mm) from the axis
  /// before contact.
  SurfaceDisplacement surfaceDisplacement(double r, double deflection, double poissonRatio) const;

protected:
  // Functions that each shape defines. They are called with finite δ > 0; `a` is contactRadius(δ).
  virtual double radiusAt(double deflection) const = 0;
  virtual double forcePerModulus(double a, double deflection) const = 0;
  // The following functions have default implementations by quadrature of g and g'.
  /// Returns p/E* at 0 <= r <= a.
  virtual double pressurePerModulus(double r, double a, double deflection) const;
  /// Returns u_z at r > a, mm.
  virtual double normalDisplacementOutside(double r, double a, double deflection) const;
  /// Returns the load within the radius r divided by E*, mm², at 0 < r < a.
  virtual double loadInside(double r, double a, double deflection) const;

  /// Returns g'(x), needed by the default implementations; 0 <= x < the largest contact radius.
  virtual double reducedSlope(double x) const = 0;

  /// Returns δ - g(a), the step at a wall at which the smooth contact ends; 0 for a smooth rim.
  double rimStep(double a, double deflection) const;

private:
  /// Returns whether the law is valid at a depth; false for NaN.
  bool answers(double deflection) const { return deflection <= this->depthLimit().depth; }
  /// Returns whether the contact is still as wide as the flat end, to 1e-8.
  bool isStillFlat(double a) const { return a <= (1.0 + 1e-8) * this->smallestContactRadius(); }
};
} // namespace palpate

#endif
