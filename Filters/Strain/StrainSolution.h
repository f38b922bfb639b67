// SPDX-License-Identifier: BSD-3-Clause
#ifndef StrainSolution_h
#define StrainSolution_h

#include "Mechanics/FiniteStrain/StrainLaw.h"
#include "Mechanics/FiniteStrain/StrainTable.h"
#include "Mechanics/Layers/LayerStack.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace palpate
{
class AxisymmetricTool;

/// A tool, and the bodies into which it is pressed.
struct StrainProblem
{
  const AxisymmetricTool& tool;
  StrainLaw law;
  /// The layers from top to bottom. The thicknesses of the first two layers, and Poisson's ratio of
  /// a single layer, are replaced by the values on the axes of the table. If there are no layers,
  /// the body is a half-space.
  LayerStack stack;
  StrainReach reach;
  std::size_t threads;
};

/// Radius of the fillets at corners of the tool, relative to the contact radius.
constexpr double SolvedFillet = 0.1;

/**
 * Returns c = F_finite/F_small at the nodes of a table, in the order of StrainTable. Both forces
 * are computed by the solver on the same mesh. c is 0 if the solver found no equilibrium. Cached
 * results are used (SolutionCache.h).
 *
 * Rows are solved on `threads` threads, which need 50 to 100 MB each. The result is bit for bit the
 * same for any number of threads. `goOn(fraction)` is called on the calling thread, about ten times
 * a second. If it returns false, the solution stops, and the result is empty.
 */
std::vector<double> solveStrain(const StrainProblem& problem, const StrainTable::Axes& axes,
  const std::function<bool(double)>& goOn);
} // namespace palpate

#endif
