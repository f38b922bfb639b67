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

/// A table of tilts, or the reason why it could not be computed.
struct MadeTilt
{
  TiltTable table;
  std::string fault;
  double error = 0.0; ///< the largest tiltError at the nodes
};

/**
 * Computes the table of a tool for tilts up to `largest` (rad) and depths up to `range` (mm), with
 * one law per body. There may be 1 to TiltTerms::MostLaws bodies. On each body τ(D, θ) = W(D,
 * θ)/W(D, 0) is computed with the tool's equivalent profiles (TiltedHalfSpace.h).
 *
 * Accuracy of the force dW/dD of the interpolated table, compared with boundary elements between
 * all nodes on a half-space (TiltNodesTest.cxx):
 * - spheres are exact, and flat ends follow their universal law;
 * - cones and blunted cones have errors of at most 0.5 %;
 * - other flat ends have errors of at most 3 % for depths of at least 0.1 of their size, and 1 %
 *   for at least 0.2;
 * - sampled profiles have errors of at most 1 %, but 6 % shortly before one of their facets is
 *   parallel to the body's surface.
 *
 * On layers tiltError() is the error of the force due to the equivalent profile. The error of the
 * torque, relative to F a, may be four times as large. For the upright tool |M| is at most 1e-3 F
 * a.
 *
 * A fault states the tilt that is too large for the tool, or the largest depth of a law. Cost: that
 * of TiltedHalfSpace, plus 0.2 s per layer on all threads. The result is bit for bit the same for
 * any number of threads.
 */
PALPATE_EXPORT MadeTilt makeTiltTable(
  const AxisymmetricTool& tool, double range, double largest, const std::vector<TiltBody>& bodies);

/// Returns the reason why a tool cannot be pressed to the depth `range` (mm) at tilts up to
/// `largest` (rad), or "".
PALPATE_EXPORT std::string checkTiltDemand(
  const AxisymmetricTool& tool, double range, double largest);

/// Computes the table of a tool from its solution on a half-space. The solution must extend at
/// least to the depth depthToSolve() and to the largest tilt.
PALPATE_EXPORT MadeTilt makeTiltTable(
  const TiltedHalfSpace& halfSpace, double range, const std::vector<TiltBody>& bodies);

/// Returns the depth (mm) to which a half-space must be solved for tables up to `range` (mm).
/// `isLayered` states whether the tables are for layers.
PALPATE_EXPORT double depthToSolve(const AxisymmetricTool& tool, double range, bool isLayered);
} // namespace palpate

#endif
