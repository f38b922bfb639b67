// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TiltViews_h
#define palpate_TiltViews_h

#include "Mechanics/PalpateExport.h"
#include "Mechanics/Tilt/TiltTable.h"

#include <cstddef>
#include <string>

namespace palpate
{
/// Tilt data of a body, in addition to the curves of the upright tool. If the tool cannot be
/// tilted, there are no laws. The views do not own their memory.
struct TiltViews
{
  TiltTerms terms;
  const double* drops = nullptr; ///< drops of the tool; see TiltTable
  const double* nodes = nullptr;
  /// Weights of the table's laws at each point; the sum of the weights is 1. Null if there is only
  /// one law.
  const float* weight = nullptr;

  bool areFelt() const noexcept { return this->terms.areFelt(); }
};

/// Checks the views for a body with `points` points. Returns "" if they are valid, else a message
/// with the fault and the value.
PALPATE_EXPORT std::string faultOfTiltViews(const TiltViews& views, std::size_t points);
} // namespace palpate

#endif
