// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SafetyText_h
#define palpate_SafetyText_h

#include "Mechanics/PalpateExport.h"

#include <cstdint>
#include <string>

namespace palpate
{
/// Describes the difference between sent and ideal force: the factor and the other links that
/// acted, in the chain's order. Example: "force ×0.12, stiffness capped". Returns "" if no link
/// acted. If `fitReason` (DeviceFit::reason) is not empty, it follows the factor in brackets.
PALPATE_EXPORT std::string describeSafety(
  std::uint16_t acted, double forceFactor, const std::string& fitReason = {});

/// Describes the force factor with two digits, for example "force ×0.12".
PALPATE_EXPORT std::string describeForceFactor(double forceFactor);
} // namespace palpate

#endif
