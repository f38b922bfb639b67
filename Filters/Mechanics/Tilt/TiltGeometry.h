// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TiltGeometry_h
#define palpate_TiltGeometry_h

#include "Mechanics/PalpateExport.h"
#include "Mechanics/Tilt/TiltTable.h"

#include <string>
#include <vector>

namespace palpate
{
class AxisymmetricTool;

/// Returns the deepest point of a tool tilted by θ >= 0 (rad). It is h = max_r [r sin θ - f cos θ]
/// below the tip, where f(r) is the profile, and x = dh/dθ = r cos θ + f sin θ to one side of the
/// tip. The result is in closed form, except for a profile given as a function.
PALPATE_EXPORT DeepestPoint deepestPoint(const AxisymmetricTool& tool, double angle);

/// Returns the largest tilt (rad) for which a law exists. It is 4 degrees less than the tilt at
/// which the steepest part of the flank is parallel to the body's surface; for a cone that tilt is
/// 90 degrees minus its half angle. It is at most 80 degrees, which is the limit for tools without
/// a flank and for flanks whose slope increases without bound.
PALPATE_EXPORT double largestTilt(const AxisymmetricTool& tool);

/// Returns the reason why a tool cannot be tilted by an angle (rad), with this angle and the
/// largest angle; "" if it can be tilted.
PALPATE_EXPORT std::string checkTilt(const AxisymmetricTool& tool, double angle);

/// Returns κ of a tool: 3 if its deepest point jumps to a rim at the smallest tilt, 0 if its
/// deepest point moves continuously. See TiltTerms::dropScale.
PALPATE_EXPORT double dropScaleOf(const AxisymmetricTool& tool);

/// The deepest point of one tool as a function of its tilt, as it is stored in a TiltTable: h and
/// dh/dθ at evenly spaced angles up to the largest angle. The interpolation is cubic between the
/// angles, and linear slightly beyond the largest.
class PALPATE_EXPORT ToolDrop
{
public:
  static constexpr int Angles = 65; ///< the error of h for a sphere is then 1e-8 of its radius

  ToolDrop(const AxisymmetricTool& tool, double largest);

  DeepestPoint at(double angle) const;
  double largest() const { return this->Largest; }
  /// h and dh/dθ at each angle.
  const std::vector<double>& nodes() const { return this->Nodes; }

private:
  double Largest;
  std::vector<double> Nodes;
};
} // namespace palpate

#endif
