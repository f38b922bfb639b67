// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactNames_h
#define palpate_ContactNames_h

#include "NumberRange.h"

#include <map>
#include <string>

namespace palpate
{
/// How the command line calls the numbers of GivenSettings.
using ContactNames = std::map<std::string, int>;
inline const ContactNames ForceFormNames = { { "paper", 0 }, { "normalized", 1 }, { "energy", 2 } };
inline const ContactNames ContactSurfaceNames = { { "facets", 0 }, { "smooth", 1 } };
inline const ContactNames FrictionModelNames = { { "elasto-plastic", 0 }, { "dahl", 1 },
  { "shape", 2 } };

constexpr double Kilometre = 1e6; // mm: no body is larger

/// What numbers it takes, as an option and as a setting of a trial's alternative.
inline constexpr NumberRange YoungsModulusRange =
  NumberRange::positive("a modulus in MPa, e.g. 0.05");
inline constexpr NumberRange PoissonsRatioRange =
  NumberRange::between(0.0, 0.5, "Poisson's ratio, e.g. 0.45");
inline constexpr NumberRange LayerRange =
  NumberRange::positive("a thickness in mm, e.g. 7, or none", Kilometre);
inline constexpr NumberRange FrictionRange =
  NumberRange::notNegative("a coefficient of friction, e.g. 0.3");
} // namespace palpate

#endif
