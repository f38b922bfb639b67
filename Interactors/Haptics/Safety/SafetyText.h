// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SafetyText_h
#define palpate_SafetyText_h

#include "Mechanics/PalpateExport.h"

#include <cstdint>
#include <string>

namespace palpate
{
/// Text that says how the force sent differs from the ideal one: the factor and the other links
/// that acted, in the chain's order. Example: "force ×0.12, stiffness capped"; "" if none acted.
PALPATE_EXPORT std::string describeSafety(std::uint16_t acted, double forceFactor);

/// Example: "force ×0.12", with two digits.
PALPATE_EXPORT std::string describeForceFactor(double forceFactor);
} // namespace palpate

#endif
