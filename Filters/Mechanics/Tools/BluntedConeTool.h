// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BluntedConeTool_h
#define palpate_BluntedConeTool_h

#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Mechanics/Tools/SphereTool.h"

#include <limits>

namespace palpate
{
/**
 * Cone of semi-angle α with a spherical tip of radius R, tangent to the cone at b = R cos α. For a
 * <= b the tool is an exact sphere. For a > b, with c = cot α, q = √(a²-b²), A = arccos(b/a), L =
 * ln[(R+a)/(R sin α+q)]
 *   δ = g(a) = a L + c a A,
 *   F = 2E* (a δ - G),  G = ∫_0^a g dx = ½ [(a²-R²) L + R a - q R/sin α + c a² A]
 * (g: Popov and Hess 2015; G by integration by parts). The strain measure is a/R, with R the radius
 * of the tip.
 */
class BluntedConeTool final : public AxisymmetricTool
{
public:
  /// `radius` is the radius of the tip, mm. `halfAngle` is measured from the axis, degrees, 0 <
  /// halfAngle < 90.
  BluntedConeTool(double radius, double halfAngle);

  std::string specification() const override;
  double profile(double r) const override;
  double forceExponent() const override { return 1.5; }
  double depthAtStrain(double ratio) const override;
  double depthAtContactRadius(double a) const override { return this->reducedProfile(a); }
  double reducedProfile(double x) const override;
  double largestContactRadius() const override { return std::numeric_limits<double>::infinity(); }
  std::vector<double> kinks() const override { return { this->Tangent }; }

protected:
  double radiusAt(double deflection) const override;
  double forcePerModulus(double a, double deflection) const override;
  double reducedSlope(double x) const override;

private:
  double logarithm(double x, double q) const;
  double slopeBehind(double x, double q) const;

  double Radius;
  double HalfAngle;
  double Cosine;
  double Sine;
  double Tangent; ///< b
  SphereTool Tip;
};
} // namespace palpate

#endif
