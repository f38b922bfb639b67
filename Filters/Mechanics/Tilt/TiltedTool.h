// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TiltedTool_h
#define palpate_TiltedTool_h

#include "Mechanics/PalpateExport.h"
#include "Mechanics/Tools/AxisymmetricTool.h"

#include <string>
#include <vector>

namespace palpate
{
/**
 * The tool of revolution that a half-space cannot tell from a tilted one: at each depth D of the
 * deepest point it has the same force, and so the same dF/dD = 2E* a. Its contact radius a(D) is
 * what it is made from; g is the inverse. On layers it stands for the tilted tool with the error of
 * tiltError.
 *
 * ln a is a cubic of ln D between the samples, beyond them a power of D, but behind a wall
 * constant. Its specification() cannot be read back.
 */
class PALPATE_EXPORT TiltedTool final : public AxisymmetricTool
{
public:
  /// a(D) at one depth.
  struct Sample
  {
    double depth;    ///< mm, > 0
    double radius;   ///< mm, > 0
    double exponent; ///< d ln a/d ln D, >= 0
  };

  /// Two samples or more, depths and radii ascending. `hasWall`: no contact is wider than the last.
  /// `kinks`: radii where a(D) bends.
  TiltedTool(
    std::string name, std::vector<Sample> samples, bool hasWall, std::vector<double> kinks = {});

  std::string specification() const override { return this->Name; }
  /// By Abel's integral of g.
  double profile(double r) const override;
  double forceExponent() const override { return 1.0 + this->Samples.front().exponent; }
  double depthAtStrain(double ratio) const override; ///< by δ/a
  double depthAtContactRadius(double a) const override;
  double reducedProfile(double x) const override;
  double largestContactRadius() const override;
  std::vector<double> kinks() const override { return this->Kinks; }

protected:
  double radiusAt(double deflection) const override;
  double forcePerModulus(double a, double deflection) const override;
  double reducedSlope(double x) const override;

private:
  /// ln a over a cell's share t, and its slope by t.
  struct Logarithm
  {
    double value;
    double slope;
  };
  Logarithm radiusIn(std::size_t cell, double t) const;
  double cellWidth(std::size_t cell) const;
  double workInside(std::size_t cell, double deflection) const;

  std::string Name;
  std::vector<Sample> Samples;
  std::vector<double> Forces; ///< F/E* at the samples
  bool HasWall;
  std::vector<double> Kinks;
};
} // namespace palpate

#endif
