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
/// Displacement of a point of the body's surface, mm. `radial` is > 0 away from the axis of the
/// tool, `normal` is > 0 into the body.
struct SurfaceDisplacement
{
  double radial;
  double normal;
};

/**
 * A rigid, frictionless tool of revolution, and its contact with an elastic half-space.
 *
 * The tool has the profile z = f(r), f(0) = 0, and is pressed to the depth δ. By the method of
 * dimensionality reduction (Galin; Sneddon 1965; Popov and Hess 2015) with
 *   g(x) = x ∫_0^{π/2} f'(x sin θ) dθ,
 * the contact radius a is the solution of g(a) = δ, the force is F = 2E* ∫_0^a (δ - g) dx, and for
 * every profile dF/dδ = 2E* a. Pressure and displacements are also computed from g
 * (DimensionalityReduction.h); shapes with closed forms override them.
 *
 * Units mm, N, MPa. δ <= 0 means no contact: every result is 0. A NaN argument results in NaN.
 * Reduced modulus E* = E/(1-ν²), see ReducedModulus.h. Linear elasticity at small strain, see
 * depthAtStrain. If g is not increasing everywhere, the formulas are not valid at large depths: for
 * depths beyond depthLimit every result is NaN. Immutable and safe to call from any number of
 * threads.
 */
class PALPATE_EXPORT AxisymmetricTool : public IndentationLaw
{
public:
  /// The tool in the form used on a command line, "sphere:6.35". The text is lossless; parseTool
  /// reads it.
  virtual std::string specification() const = 0;

  /// f(r), mm: height of the tool's surface above its tip. +inf beyond its outer wall.
  virtual double profile(double r) const = 0;

  /// Exponent m of F ∝ δ^m at small depth. For a sampled profile, whose tip is a straight segment,
  /// the exponent half way to its wall.
  virtual double forceExponent() const = 0;

  /// Depth (mm) above which the strain measure a/R exceeds `ratio`; a/R is the contact radius
  /// divided by the tip radius. For tools without a tip radius the measure is δ/a, which equals a/R
  /// for a paraboloid. 0 if the measure exceeds `ratio` at first contact, +inf if it never does.
  virtual double depthAtStrain(double ratio) const = 0;

  /// Depth (mm) at which the contact radius is a: g(a). 0 if the contact radius exceeds a at every
  /// depth, +inf if it is less than a at every depth.
  virtual double depthAtContactRadius(double a) const = 0;

  /// g(x), mm, for smallestContactRadius <= x < largestContactRadius; 0 below.
  virtual double reducedProfile(double x) const = 0;
  /// Contact radius at first contact: the radius of the flat end, or 0. mm.
  virtual double smallestContactRadius() const { return 0.0; }
  /// Upper bound of the contact radius: the radius of the outer wall, or +inf. mm.
  virtual double largestContactRadius() const = 0;
  /// Radii > 0 (mm, ascending) at which g is not analytic, including the smallest contact radius.
  virtual std::vector<double> kinks() const { return {}; }

  /// The depth beyond which the tool would touch the body outside the circle of contact, and the
  /// radius of that second contact.
  virtual DepthLimit depthLimit() const { return {}; }
  /// The reason why the law is not valid at a deflection, with both depths and the radius; empty if
  /// it is valid.
  std::string checkDepth(double deflection) const;

  IndentationPoint evaluate(double deflection, double reducedModulus) const final;
  double contactRadius(double deflection) const;
  double force(double deflection, double reducedModulus) const;
  /// dF/dδ, N/mm.
  double stiffness(double deflection, double reducedModulus) const;
  /// Contact pressure at distance r from the axis, MPa; 0 outside the contact, +inf at a sharp rim
  /// or apex.
  double pressure(double r, double deflection, double reducedModulus) const;
  /// Displacement of the surface point that was at the distance r (mm) from the axis before
  /// contact.
  SurfaceDisplacement surfaceDisplacement(double r, double deflection, double poissonRatio) const;

protected:
  // Functions that a shape defines. They are called with finite δ > 0; `a` is contactRadius(δ).
  virtual double radiusAt(double deflection) const = 0;
  virtual double forcePerModulus(double a, double deflection) const = 0;
  // The following functions have defaults, by quadrature of g and g'.
  /// p/E* at 0 <= r <= a.
  virtual double pressurePerModulus(double r, double a, double deflection) const;
  /// u_z at r > a.
  virtual double normalDisplacementOutside(double r, double a, double deflection) const;
  /// Load within the radius r divided by E*, mm², at 0 < r < a.
  virtual double loadInside(double r, double a, double deflection) const;

  /// g'(x), for the defaults; 0 <= x < the largest contact radius.
  virtual double reducedSlope(double x) const = 0;

  /// The step at a wall that ends the smooth contact: δ - g(a); 0 for a smooth rim.
  double rimStep(double a, double deflection) const;

private:
  /// Whether the law is valid at a depth; false for NaN.
  bool answers(double deflection) const { return deflection <= this->depthLimit().depth; }
  /// Whether the contact is still as wide as the flat end, to 1e-8.
  bool isStillFlat(double a) const { return a <= (1.0 + 1e-8) * this->smallestContactRadius(); }
};
} // namespace palpate

#endif
