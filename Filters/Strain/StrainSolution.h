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

/// A tool and the bodies that it is pressed into.
struct StrainProblem
{
  const AxisymmetricTool& tool;
  StrainLaw law;
  /// From the top; the thickness of the first two, and the ratio of a single one, come from the
  /// axes of the table. Without layers: a half-space.
  LayerStack stack;
  StrainReach reach;
  std::size_t threads;
};

/// Radius of the fillets of corners, relative to the contact radius.
constexpr double SolvedFillet = 0.1;

/**
 * c = F_finite/F_small of the solver, on one mesh, at the nodes of a table, as for StrainTable; 0
 * where it found no equilibrium. From the cache (StrainCache.h) if it has them.
 *
 * Row by row on `threads` threads, 50 to 100 MB each, with the same bits for any number of
 * them. `goOn(fraction)` is called on the calling thread, some ten times a second; returning false
 * ends it without factors.
 */
std::vector<double> solveStrain(const StrainProblem& problem, const StrainTable::Axes& axes,
  const std::function<bool(double)>& goOn);
} // namespace palpate

#endif
