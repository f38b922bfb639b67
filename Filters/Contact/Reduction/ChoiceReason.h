// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ChoiceReason_h
#define palpate_ChoiceReason_h

#include "Mechanics/PalpateExport.h"
#include "Contact/Reduction/ResponseChoice.h"

#include <string>

namespace palpate
{
/// Describes the chosen form, its error, the reason why no simpler form suffices, and the points at
/// which the law does not hold. `before` is the number of stored numbers per point of the original
/// response.
PALPATE_EXPORT std::string choiceReason(
  const ResponseChoice& choice, const ChoiceSettings& settings, int before);
} // namespace palpate

#endif
