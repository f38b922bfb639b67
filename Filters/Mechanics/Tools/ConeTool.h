// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ConeTool_h
#define palpate_ConeTool_h

#include "Mechanics/Tools/AxisymmetricTool.h"

#include <limits>

namespace palpate
{
/**
 * Cone of semi-angle α measured from its axis, f = r cot α: a = 2δ tan α/π, F = (2/π) E* tan α δ²
 * (Sneddon 1965). Its strain is the same at every depth: δ/a = (π/2) cot α. The pressure is
 * infinite at the apex.
 */
class ConeTool final : public AxisymmetricTool
{
public:
  /// `halfAngle` is measured from the axis, degrees, 0 < halfAngle < 90.
  explicit ConeTool(double halfAngle);

  std::string specification() const override;
  double profile(double r) const override;
  double forceExponent() const override { return 2.0; }
  double depthAtStrain(double ratio) const override;
  double depthAtContactRadius(double a) const override;
  double reducedProfile(double x) const override;
  double largestContactRadius() const override { return std::numeric_limits<double>::infinity(); }

protected:
  double radiusAt(double deflection) const override;
  double forcePerModulus(double a, double deflection) const override;
  double pressurePerModulus(double r, double a, double deflection) const override;
  double normalDisplacementOutside(double r, double a, double deflection) const override;
  double loadInside(double r, double a, double deflection) const override;
  double reducedSlope(double x) const override;

private:
  double HalfAngle;
  double Slope; ///< cot α
};
} // namespace palpate

#endif
