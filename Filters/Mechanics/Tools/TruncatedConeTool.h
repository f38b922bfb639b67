// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TruncatedConeTool_h
#define palpate_TruncatedConeTool_h

#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Mechanics/Tools/SlopeStep.h"

#include <limits>

namespace palpate
{
/**
 * Cone of semi-angle α cut to a flat of radius b, f = (r-b) cot α for r > b: with A = arccos(b/a)
 *   δ = a A cot α,  F = E* cot α [a²A + b√(a²-b²)]
 * (Ejike 1969; Popov and Hess 2015). At first contact it is a flat punch of radius b; the pressure
 * is infinite at the edge r = b. There is no tip radius: the strain measure is δ/a = A cot α.
 */
class TruncatedConeTool final : public AxisymmetricTool
{
public:
  /// `radius` is the radius of the flat end, mm. `halfAngle` is measured from the axis, degrees, 0
  /// < halfAngle < 90.
  TruncatedConeTool(double radius, double halfAngle);

  std::string specification() const override;
  double profile(double r) const override;
  double forceExponent() const override { return 1.0; }
  double depthAtStrain(double ratio) const override;
  double depthAtContactRadius(double a) const override { return this->reducedProfile(a); }
  double reducedProfile(double x) const override;
  double smallestContactRadius() const override { return this->Edge.radius(); }
  double largestContactRadius() const override { return std::numeric_limits<double>::infinity(); }
  std::vector<double> kinks() const override { return { this->Edge.radius() }; }

protected:
  double radiusAt(double deflection) const override;
  double forcePerModulus(double a, double deflection) const override;
  double pressurePerModulus(double r, double a, double deflection) const override;
  double loadInside(double r, double a, double deflection) const override;
  double reducedSlope(double x) const override;

private:
  SlopeStep Edge;
  double HalfAngle;
  double Slope; ///< cot α
};
} // namespace palpate

#endif
