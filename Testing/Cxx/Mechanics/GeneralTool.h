// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_GeneralTool_h
#define palpate_GeneralTool_h

#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Mechanics/Numerics/IncreasingRoot.h"

#include <functional>
#include <limits>
#include <vector>

namespace palpate
{
/**
 * A tool given by its profile f as a function, for a shape without its own class. All results are
 * computed from f by quadrature, with the general code for any profile (DimensionalityReduction.h).
 * The nine shapes have closed forms, and the tests compare both.
 * Accuracy: about 1e-9. Cost: an evaluation takes about 0.1 ms for each kink below the contact
 * radius, pressure and displacements ten times as long. g must increase, otherwise the law is wrong
 * from some depth on; this depth is computed if `outer` is set. specification() is empty, because a
 * function has no text form.
 */
class GeneralTool final : public AxisymmetricTool
{
public:
  using Function = std::function<double(double)>;
  /// The profile f(r), its derivatives and its non-smooth points. Radii in mm.
  struct Shape
  {
    Function profile;          ///< f, mm, f(0) = 0
    Function slope;            ///< f'
    Function curvature;        ///< f'', 1/mm
    std::vector<double> kinks; ///< radii > 0, ascending, where f is not analytic
    double flat = 0.0;         ///< radius within which f = 0: a kink, or the outer radius
    double outer = std::numeric_limits<double>::infinity(); ///< radius of the wall, if any
    double exponent = 1.0;                                  ///< m of F ∝ δ^m at small depth
  };
  explicit GeneralTool(Shape shape);

  std::string specification() const override { return {}; }
  double profile(double r) const override;
  double forceExponent() const override { return this->Given.exponent; }
  /// Depth at which the strain δ/a has the given value, mm.
  double depthAtStrain(double ratio) const override;
  double depthAtContactRadius(double a) const override;
  double reducedProfile(double x) const override;
  double smallestContactRadius() const override { return this->Given.flat; }
  double largestContactRadius() const override { return this->Given.outer; }
  std::vector<double> kinks() const override { return this->Given.kinks; }
  DepthLimit depthLimit() const override { return this->Limit; }

protected:
  double radiusAt(double deflection) const override;
  double forcePerModulus(double a, double deflection) const override;
  double reducedSlope(double x) const override;

private:
  double passage(const std::function<ValueAndSlope(double)>& excess) const;

  Shape Given;
  DepthLimit Limit;
};
} // namespace palpate

#endif
