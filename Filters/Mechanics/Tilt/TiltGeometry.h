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

/// Where a tool tilted by θ >= 0 (rad) is deepest: h = max_r [r sin θ - f cos θ] below its tip and
/// x = dh/dθ = r cos θ + f sin θ beside it. In closed form but for a profile given as a function.
PALPATE_EXPORT DeepestPoint deepestPoint(const AxisymmetricTool& tool, double angle);

/// The largest tilt (rad) that has a law: 4 degrees before the steepest part of the flank lies on
/// the body, of a cone 90 degrees less its half angle; 80 degrees where the flank grows ever
/// steeper, or there is none.
PALPATE_EXPORT double largestTilt(const AxisymmetricTool& tool);

/// Why a tool cannot be tilted so far (rad), naming both angles; "" if it can.
PALPATE_EXPORT std::string checkTilt(const AxisymmetricTool& tool, double angle);

/// κ of a tool: 3 if its deepest point jumps to a rim at any tilt, 0 if it moves continuously. See
/// TiltTerms::dropScale.
PALPATE_EXPORT double dropScaleOf(const AxisymmetricTool& tool);

/// The deepest point of one tool over its tilt as a TiltTable stores it: h and dh/dθ at even angles
/// up to the largest, cubic between, and linear slightly beyond.
class PALPATE_EXPORT ToolDrop
{
public:
  static constexpr int Angles = 65; ///< h of a sphere to 1e-8 of its radius

  ToolDrop(const AxisymmetricTool& tool, double largest);

  DeepestPoint at(double angle) const;
  double largest() const { return this->Largest; }
  /// h and dh/dθ of each angle.
  const std::vector<double>& nodes() const { return this->Nodes; }

private:
  double Largest;
  std::vector<double> Nodes;
};
} // namespace palpate

#endif
