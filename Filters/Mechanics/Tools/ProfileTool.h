// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ProfileTool_h
#define palpate_ProfileTool_h

#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Mechanics/Numerics/IncreasingRoot.h"
#include "Mechanics/PalpateExport.h"
#include "Mechanics/Tools/SlopeStep.h"

#include <vector>

namespace palpate
{
/// A point of a tool's profile, mm: distance from the axis, height above the tip.
struct ProfilePoint
{
  double r;
  double f;
};

/**
 * A tool whose profile is sampled from its axis outward. The profile is straight between the
 * points, with a vertical wall at the last point.
 *
 * Its slope changes by m_i at r_i. In closed form, with A_i = arccos(r_i/a) and r_i < a,
 *   δ = Σ m_i a A_i,  F = 2E* (a δ - ½ Σ m_i [a² A_i - r_i √(a²-r_i²)]).
 * For depths beyond g at the wall, a flat punch is added. If the points are on a smooth profile,
 * the error of the law is proportional to the square of their spacing. The two points (0, 0) and
 * (R, 0) define a flat punch.
 *
 * If a concave profile would touch the body outside the circle of contact, the law ends at that
 * depth (DepthLimit.h). Next to an edge r_i the pressure is infinite: +inf at a convex edge, -inf
 * at a concave one.
 *
 * There is no tip radius, so that the strain measure is δ/a. The cost is proportional to the number
 * of points, about 30 ns per point for force and radius, 2 µs per point for pressure and
 * displacements. The construction of a profile that is not convex takes a time proportional to the
 * square of the number of points, 0.1 s for a thousand points.
 */
class PALPATE_EXPORT ProfileTool final : public AxisymmetricTool
{
public:
  /// Returns the fault of the points with the first invalid point, or "".
  static std::string check(const std::vector<ProfilePoint>& points);
  /// Returns the fault of the last point, or "". The points before it must have no fault.
  static std::string checkLast(const std::vector<ProfilePoint>& points);

  /// The points must pass check(): there are two or more, the first is (0, 0), r increases, and f
  /// >= 0.
  explicit ProfileTool(std::vector<ProfilePoint> points);

  std::string specification() const override;
  double profile(double r) const override;
  double forceExponent() const override { return this->MiddleExponent; }
  double depthAtStrain(double ratio) const override;
  double depthAtContactRadius(double a) const override;
  double reducedProfile(double x) const override;
  double smallestContactRadius() const override;
  double largestContactRadius() const override { return this->Points.back().r; }
  std::vector<double> kinks() const override;
  DepthLimit depthLimit() const override { return this->Limit; }

protected:
  double radiusAt(double deflection) const override;
  double forcePerModulus(double a, double deflection) const override;
  double pressurePerModulus(double r, double a, double deflection) const override;
  double normalDisplacementOutside(double r, double a, double deflection) const override;
  double loadInside(double r, double a, double deflection) const override;
  double reducedSlope(double x) const override;

private:
  /// A change of slope.
  struct Step
  {
    SlopeStep unit;
    double change;
  };
  /// A point x = √(r²+t²) at which g reaches a new maximum; r is the radius of the preceding step.
  struct Rise
  {
    std::size_t step;
    double t;
    double level;
  };
  ValueAndSlope behind(std::size_t step, double t) const;
  void findRises();

  std::vector<ProfilePoint> Points;
  std::vector<Step> Steps; ///< ascending radii
  std::vector<Rise> Rises; ///< ascending levels
  DepthLimit Limit;
  double MiddleExponent = 1.0;
};
} // namespace palpate

#endif
