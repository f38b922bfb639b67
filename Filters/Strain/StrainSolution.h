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
  /// The layers from the top. The thickness of the first two layers, and the Poisson's ratio of a
  /// single layer, come from the axes of the table. No layers: a half-space.
  LayerStack stack;
  StrainReach reach;
  std::size_t threads;
};

/// Radius of the fillets of corners, relative to the contact radius.
constexpr double SolvedFillet = 0.1;

/**
 * c = F_finite/F_small of the solver, both on one mesh, at the nodes of a table, in the order of
 * StrainTable. 0 where the solver found no equilibrium. The result comes from the cache
 * (StrainCache.h) if it is there.
 *
 * Rows are solved on `threads` threads, with 50 to 100 MB each. The bits do not depend on the
 * number of threads. `goOn(fraction)` is called on the calling thread, about ten times a second. If
 * it returns false, the solution stops, and the result is empty.
 */
std::vector<double> solveStrain(const StrainProblem& problem, const StrainTable::Axes& axes,
  const std::function<bool(double)>& goOn);
} // namespace palpate

#endif
