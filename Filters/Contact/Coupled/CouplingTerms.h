// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CouplingTerms_h
#define palpate_CouplingTerms_h

#include "Mechanics/Coupling/CouplingLaw.h"
#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <string>

namespace palpate
{
/// Data for the coupling of contacts on one body. The views do not own their memory.
struct CouplingTerms
{
  static constexpr int MostModes = 16;

  /// E* of the half-space or of the top layer, MPa. With 0, contacts are coupled only by the modes.
  double modulus = 0.0;
  /// Thickness of the layer, mm; 0 for a half-space.
  double thickness = 0.0;
  /// CouplingLaw::KnotCount knots of the layer's coupling law; null for a half-space.
  const CouplingKnot* knots = nullptr;
  /// E* (MPa) and thickness (mm) at each point, used instead of `modulus` and `thickness`. Null if
  /// those values apply to all points.
  const float* localModulus = nullptr;
  const float* localThickness = nullptr;
  /// Inward displacement of each point along its normal in each mode φ of the body, √(mm/N);
  /// `modeCount` values per point. The modes add Σ φ(i) φ(j) to the compliance C_ij. Null if there
  /// are no modes.
  const float* modes = nullptr;
  int modeCount = 0;

  bool areFelt() const noexcept { return this->modulus > 0.0 || this->modeCount > 0; }
};

/// Checks the terms for a body with `points` points. Returns "" if they are valid, else a message.
PALPATE_EXPORT std::string faultOfCoupling(const CouplingTerms& terms, std::size_t points);
} // namespace palpate

#endif
