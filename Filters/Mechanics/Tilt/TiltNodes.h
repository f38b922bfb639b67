// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TiltNodes_h
#define palpate_TiltNodes_h

#include "Mechanics/PalpateExport.h"
#include "Mechanics/Tilt/TiltBody.h"
#include "Mechanics/Tilt/TiltTable.h"

#include <string>
#include <vector>

namespace palpate
{
class AxisymmetricTool;
class TiltedHalfSpace;

/// A table of tilts, or why there is none.
struct MadeTilt
{
  TiltTable table;
  std::string fault;
  double error = 0.0; ///< the largest by tiltError at the nodes
};

/**
 * The table of a tool for tilts up to `largest` (rad) and depths up to `range` (mm), one law per
 * body, 1 to TiltTerms::MostLaws. τ(D, θ) = W(D, θ)/W(D, 0) of the tool's equivalent profiles
 * (TiltedHalfSpace.h) on each.
 *
 * Force of the interpolated table, dW/dD, against boundary elements between all nodes on a
 * half-space: spheres exact, flat ends as their universal law, cones and blunted cones 0.5 %, other
 * flat ends 3 % from a depth of 0.1 of their size on and 1 % from 0.2 (TiltNodesTest.cxx); sampled
 * profiles 1 %, but 6 % where one of their facets is about to lie on the body. On layers tiltError
 * is the error of the force by the equivalent profile; that of the torque may be four times as
 * large, relative to F a. Upright M is 0 to 1e-3 F a.
 *
 * A fault names the tilt that is too large for the tool, or the largest depth of a law. Cost: that
 * of TiltedHalfSpace and 0.2 s per layer, on all threads; same bits whatever the threads.
 */
PALPATE_EXPORT MadeTilt makeTiltTable(
  const AxisymmetricTool& tool, double range, double largest, const std::vector<TiltBody>& bodies);

/// Why a tool cannot be pressed so deep (mm) and tilted so far (rad), or "".
PALPATE_EXPORT std::string checkTiltDemand(
  const AxisymmetricTool& tool, double range, double largest);

/// The same for a tool that was solved for already, at least to depthToSolve, and up to its largest
/// tilt.
PALPATE_EXPORT MadeTilt makeTiltTable(
  const TiltedHalfSpace& halfSpace, double range, const std::vector<TiltBody>& bodies);

/// The depth (mm) to which a half-space must be solved for tables to `range`, on layers or not.
PALPATE_EXPORT double depthToSolve(const AxisymmetricTool& tool, double range, bool isLayered);
} // namespace palpate

#endif
