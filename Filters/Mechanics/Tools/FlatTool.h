// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FlatTool_h
#define palpate_FlatTool_h

#include "Mechanics/Tools/AxisymmetricTool.h"

namespace palpate
{
/**
 * Flat-ended cylindrical punch of radius a: F = 2 a E* δ (Boussinesq; Sneddon 1965).
 * The contact radius is a at every depth; the pressure is infinite at the rim.
 */
class FlatTool final : public AxisymmetricTool
{
public:
  explicit FlatTool(double radius);

  std::string specification() const override;
  double profile(double r) const override;
  double forceExponent() const override { return 1.0; }
  double depthAtStrain(double ratio) const override;
  double depthAtContactRadius(double a) const override;
  double reducedProfile(double) const override { return 0.0; }
  double smallestContactRadius() const override { return this->Radius; }
  double largestContactRadius() const override { return this->Radius; }
  std::vector<double> kinks() const override { return { this->Radius }; }

protected:
  double radiusAt(double deflection) const override;
  double forcePerModulus(double a, double deflection) const override;
  double pressurePerModulus(double r, double a, double deflection) const override;
  double normalDisplacementOutside(double r, double a, double deflection) const override;
  double loadInside(double r, double a, double deflection) const override;
  double reducedSlope(double) const override { return 0.0; }

private:
  double Radius;
};
} // namespace palpate

#endif
