// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SphereTool_h
#define palpate_SphereTool_h

#include "Mechanics/Tools/AxisymmetricTool.h"

namespace palpate
{
/**
 * Exact sphere of radius R. With w = artanh(a/R),
 *   δ = R w tanh w,  F = E* [(a²+R²) w - a R],  a = R tanh w < R at every depth
 * (Sneddon 1965, sec. 5.3). To first order in a/R this is Hertz's paraboloid, F = 4/3 E* √R δ^1.5.
 * The often-copied form 4/3 √(R E*) δ^1.5 is wrong, because it does not have the unit of a force.
 * Pressure and displacements outside the contact are computed by quadrature, with an error of about
 * 1e-11 for a/R <= 0.99.
 */
class SphereTool final : public AxisymmetricTool
{
public:
  explicit SphereTool(double radius);

  std::string specification() const override;
  double profile(double r) const override;
  double forceExponent() const override { return 1.5; }
  double depthAtStrain(double ratio) const override;
  double depthAtContactRadius(double a) const override;
  double reducedProfile(double x) const override;
  double largestContactRadius() const override { return this->Radius; }

protected:
  double radiusAt(double deflection) const override;
  double forcePerModulus(double a, double deflection) const override;
  double reducedSlope(double x) const override;

private:
  double Radius;
};
} // namespace palpate

#endif
