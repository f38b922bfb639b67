// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ParaboloidTool_h
#define palpate_ParaboloidTool_h

#include "Mechanics/Tools/AxisymmetricTool.h"

#include <limits>

namespace palpate
{
/**
 * Paraboloid f = r²/2R, which Hertz (1882) and the usual tables call "sphere": a = √(Rδ), F = 4/3
 * E* √R δ^1.5. It approximates a sphere of radius R for a << R; the exact sphere is SphereTool.
 */
class ParaboloidTool final : public AxisymmetricTool
{
public:
  explicit ParaboloidTool(double radius);

  std::string specification() const override;
  double profile(double r) const override;
  double forceExponent() const override { return 1.5; }
  double depthAtStrain(double ratio) const override;
  double depthAtContactRadius(double a) const override;
  double reducedProfile(double x) const override { return x * x / this->Radius; }
  double largestContactRadius() const override { return std::numeric_limits<double>::infinity(); }

protected:
  double radiusAt(double deflection) const override;
  double forcePerModulus(double a, double deflection) const override;
  double pressurePerModulus(double r, double a, double deflection) const override;
  double normalDisplacementOutside(double r, double a, double deflection) const override;
  double loadInside(double r, double a, double deflection) const override;
  double reducedSlope(double x) const override { return 2.0 * x / this->Radius; }

private:
  double Radius;
};
} // namespace palpate

#endif
