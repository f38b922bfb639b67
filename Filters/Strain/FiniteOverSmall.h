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

/// Returns the outline of a tool for the solver, up to three times `contactRadius` (mm). Its
/// corners have fillets of radius `fillet` (mm).
ToolOutline solvedOutline(const AxisymmetricTool& tool, double contactRadius, double fillet);

/**
 * Returns c = F_finite/F_small at the depths of `problem`. Both forces are solved on the same mesh.
 * c is 0 without contact, and at all depths beyond the last equilibrium. If `goOn(fraction)`
 * returns false, the values found so far are returned.
 *
 * The tool's corners have fillets of radius `fillet` (mm). Under a sharp rim the surface creases,
 * and the elements turn inside out before the depth reaches the width of the tool. Therefore c is
 * used up to a depth of 6.5 fillet radii. For larger depths it is continued with results for
 * fillets whose radii are 1.5, 2 and 3 times as large. The ratio of c for two fillets changes
 * little with the depth. For a flat end this can be checked: the ratio changes by 0.5 % from 0.6
 * to 1.1 radii, and at ν = 0.495 it decreases by 1.5 %.
 */
std::vector<double> finiteOverSmall(const AxisymmetricTool& tool, const FiniteProblem& problem,
  double fillet, const std::function<bool(double)>& goOn);
} // namespace palpate

#endif
