// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TiltViews_h
#define palpate_TiltViews_h

#include "Mechanics/PalpateExport.h"
#include "Mechanics/Tilt/TiltTable.h"

#include <cstddef>
#include <string>

namespace palpate
{
/// What a tick needs of a tool that may be tilted, beside the curves, which are those of the tool
/// upright; of one that may not there are no laws. Views of somebody else's memory.
struct TiltViews
{
  TiltTerms terms;
  const double* drops = nullptr; ///< see TiltTable
  const double* nodes = nullptr;
  /// Of the table's laws at each point, sum 1; null: there is one law.
  const float* weight = nullptr;

  bool areFelt() const noexcept { return this->terms.areFelt(); }
};

/// What is wrong with those of a body of so many points, naming it and the number; "" for what can
/// be felt.
PALPATE_EXPORT std::string faultOfTiltViews(const TiltViews& views, std::size_t points);
} // namespace palpate

#endif
