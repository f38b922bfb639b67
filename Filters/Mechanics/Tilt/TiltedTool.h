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
 * The tool of revolution that is equivalent to a tilted tool on a half-space: at each depth D of
 * the deepest point it has the same force, and therefore the same dF/dD = 2E* a. It is defined by
 * its contact radius a(D); its reduced profile g is the inverse function. On layers the equivalent
 * tool causes the error tiltError().
 *
 * ln a is a cubic of ln D between the samples. Beyond the samples a is a power of D, except that it
 * is constant beyond a wall. The specification() of this tool cannot be parsed.
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

  /// `samples` has at least two samples, with ascending depths and radii. `hasWall` means that no
  /// contact is wider than the last sample. `kinks` are the radii at which the slope of a(D) is
  /// discontinuous.
  TiltedTool(
    std::string name, std::vector<Sample> samples, bool hasWall, std::vector<double> kinks = {});

  std::string specification() const override { return this->Name; }
  /// Computed as Abel's integral of g.
  double profile(double r) const override;
  double forceExponent() const override { return 1.0 + this->Samples.front().exponent; }
  double depthAtStrain(double ratio) const override; ///< the strain measure is δ/a
  double depthAtContactRadius(double a) const override;
  double reducedProfile(double x) const override;
  double largestContactRadius() const override;
  std::vector<double> kinks() const override { return this->Kinks; }

protected:
  double radiusAt(double deflection) const override;
  double forcePerModulus(double a, double deflection) const override;
  double reducedSlope(double x) const override;

private:
  /// ln a at the fraction t of a cell, and its derivative with respect to t.
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
