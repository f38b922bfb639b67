// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactNames_h
#define palpate_ContactNames_h

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
} // namespace palpate

#endif
