// SPDX-License-Identifier: BSD-3-Clause
#ifndef SolvedTable_h
#define SolvedTable_h

#include "Mechanics/FiniteStrain/StrainModule.h"

#include <functional>
#include <memory>

namespace palpate
{
/// Return tables of c with the values of solveStrain(), for a half-space and for layers, with their
/// nodes and errors. Null if `goOn(fraction)` returned false.
std::unique_ptr<StrainTable> solveOnHalfSpace(
  const SolvedStrain& asked, const std::function<bool(double)>& goOn);
std::unique_ptr<StrainTable> solveOnLayers(
  const SolvedStrain& asked, const std::function<bool(double)>& goOn);
} // namespace palpate

#endif
