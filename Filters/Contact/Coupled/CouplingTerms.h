// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CouplingTerms_h
#define palpate_CouplingTerms_h

#include "Mechanics/Coupling/CouplingLaw.h"
#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <string>

namespace palpate
{
/// What contacts on one body need to feel one another, beside its curves. Views of somebody else's
/// memory.
struct CouplingTerms
{
  static constexpr int MostModes = 16;

  /// E* of the half-space, or of the top layer, MPa; 0: only the modes couple, if there are any.
  double modulus = 0.0;
  /// Of the layer, mm; 0: a half-space.
  double thickness = 0.0;
  /// Of a layer, CouplingLaw::KnotCount; null: a half-space.
  const CouplingKnot* knots = nullptr;
  /// E* and thickness at each point instead; null: everywhere the same.
  const float* localModulus = nullptr;
  const float* localThickness = nullptr;
  /// By how much modes of the body move each point inward along its normal, √(mm/N), so many a
  /// point: C_ij = Σ φ(i) φ(j) beside that of the surface. Null: none.
  const float* modes = nullptr;
  int modeCount = 0;

  bool areFelt() const noexcept { return this->modulus > 0.0 || this->modeCount > 0; }
};

/// What is wrong with the terms of a body of so many points, or "".
PALPATE_EXPORT std::string faultOfCoupling(const CouplingTerms& terms, std::size_t points);
} // namespace palpate

#endif
