// SPDX-License-Identifier: BSD-3-Clause
#ifndef FiniteOverSmall_h
#define FiniteOverSmall_h

#include "Strain/FiniteIndentation.h"
#include "Mechanics/FiniteStrain/ToolOutline.h"

#include <functional>
#include <vector>

namespace palpate
{
class AxisymmetricTool;

/// The outline of a tool for the solver: out to three times `contactRadius`, its corners with
/// fillets of radius `fillet` (both mm).
ToolOutline solvedOutline(const AxisymmetricTool& tool, double contactRadius, double fillet);

/**
 * c = F_finite/F_small at the depths of `problem`, both solved on one mesh; 0 from the first depth
 * on without equilibrium, and without contact. If `goOn(fraction)` ends it, the values so far.
 *
 * The tool's corners have fillets of radius `fillet` (mm). Under a sharp rim the surface creases
 * and the elements turn inside out before the tool is as deep as it is wide: c is used to a depth
 * of 6.5 fillets, and continued from there by rims 1.5, 2 and 3 times as round. The ratio of c of
 * two rims hardly changes with the depth (0.5 % from 0.6 to 1.1 radii of a flat, where it can be
 * compared; at ν = 0.495 it falls by 1.5 %).
 */
std::vector<double> finiteOverSmall(const AxisymmetricTool& tool, const FiniteProblem& problem,
  double fillet, const std::function<bool(double)>& goOn);
} // namespace palpate

#endif
