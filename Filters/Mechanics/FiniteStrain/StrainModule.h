// SPDX-License-Identifier: BSD-3-Clause
#ifndef StrainModule_h
#define StrainModule_h

#include "Mechanics/Files/ModuleFile.h"
#include "Mechanics/FiniteStrain/StrainCorrection.h"

#include <cstddef>
#include <functional>
#include <memory>

namespace palpate
{
class AxisymmetricTool;

/// A tool and bodies for which no table of finite strain is stored.
struct SolvedStrain
{
  const AxisymmetricTool& tool;
  StrainLaw law;
  const StrainBodies& bodies;
  double deepest;      ///< mm
  std::size_t threads; ///< number of threads of the solver
};

/// The largest Poisson's ratio for which the solver is used, and the change of c from that ratio to
/// 0.5 at δ = R.
constexpr double LargestSolvedRatio = 0.495;
constexpr double BeyondSolvedRatio = 0.006;

/**
 * Functions that libpalpateStrain.so (folder Strain) provides: tables computed by the solver.
 * StrainCorrection calls them if no stored table covers the case. They return null if
 * `goOn(fraction)` returned false.
 */
struct StrainModule : ModuleTable
{
  using Solver = std::unique_ptr<StrainTable> (*)(
    const SolvedStrain& asked, const std::function<bool(double)>& goOn);
  Solver onHalfSpace;
  Solver onLayers;
};
} // namespace palpate

#endif
