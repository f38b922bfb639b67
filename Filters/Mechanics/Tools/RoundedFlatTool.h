// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RoundedFlatTool_h
#define palpate_RoundedFlatTool_h

#include "Mechanics/Tools/AxisymmetricTool.h"

#include <limits>

namespace palpate
{
/**
 * Flat punch of radius b with a rounded edge, f = (r-b)²/2R_e for r > b: with A = arccos(b/a) and
 * q = √(a²-b²)
 *   δ = (a/R_e) (q - bA),  F = E* [(4a²-b²) q - 3a²bA]/(3R_e)
 * (Schubert 1942; Popov and Hess 2015). At first contact it is a flat punch of radius b; the
 * pressure is finite everywhere. There is no tip radius: the strain measure is δ/a = (q - bA)/R_e.
 */
class RoundedFlatTool final : public AxisymmetricTool
{
public:
  /// `radius` is the radius of the flat part, `edgeRadius` that of the rounded edge, mm.
  RoundedFlatTool(double radius, double edgeRadius);

  std::string specification() const override;
  double profile(double r) const override;
  double forceExponent() const override { return 1.0; }
  double depthAtStrain(double ratio) const override;
  double depthAtContactRadius(double a) const override { return this->reducedProfile(a); }
  double reducedProfile(double x) const override;
  double smallestContactRadius() const override { return this->Radius; }
  double largestContactRadius() const override { return std::numeric_limits<double>::infinity(); }
  std::vector<double> kinks() const override { return { this->Radius }; }

protected:
  double radiusAt(double deflection) const override;
  double forcePerModulus(double a, double deflection) const override;
  double reducedSlope(double x) const override;

private:
  double Radius;
  double EdgeRadius;
};
} // namespace palpate

#endif
