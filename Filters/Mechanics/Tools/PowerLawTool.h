// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PowerLawTool_h
#define palpate_PowerLawTool_h

#include "Mechanics/Tools/AxisymmetricTool.h"

#include <limits>

namespace palpate
{
/**
 * Profile f = B r^n: with κ = (√π/2) n Γ(n/2)/Γ((n+1)/2)
 *   δ = κ B a^n,  F = 2n/(n+1) E* a δ ∝ δ^(1+1/n)
 * (Galin; Sneddon 1965; Popov and Hess 2015). n = 1 is the cone, n = 2 the paraboloid B = 1/2R.
 *
 * The exponent must be 1 <= n <= 100. For n < 1 the tip would be a cusp of infinite slope, for
 * which a theory of small slopes is not valid. For n > 100 the profile differs from a flat punch by
 * a few per cent of its radius; RoundedFlatTool describes such a tool better.
 *
 * There is no tip radius, so that the strain measure is δ/a = κ B a^(n-1), which for n = 1 is the
 * same at every depth.
 */
class PowerLawTool final : public AxisymmetricTool
{
public:
  static constexpr double LargestExponent = 100.0;

  /// `exponent` is n; `coefficient` is B, mm^(1-n), > 0.
  PowerLawTool(double exponent, double coefficient);

  std::string specification() const override;
  double profile(double r) const override;
  double forceExponent() const override { return 1.0 + 1.0 / this->Exponent; }
  double depthAtStrain(double ratio) const override;
  double depthAtContactRadius(double a) const override { return this->reducedProfile(a); }
  double reducedProfile(double x) const override;
  double largestContactRadius() const override { return std::numeric_limits<double>::infinity(); }

protected:
  double radiusAt(double deflection) const override;
  double forcePerModulus(double a, double deflection) const override;
  double pressurePerModulus(double r, double a, double deflection) const override;
  double reducedSlope(double x) const override;

private:
  double Exponent;
  double Coefficient;
  double ReducedCoefficient; ///< κB
};
} // namespace palpate

#endif
