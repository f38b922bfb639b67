// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ChoiceReason_h
#define palpate_ChoiceReason_h

#include "Mechanics/PalpateExport.h"
#include "Contact/Reduction/ResponseChoice.h"

#include <string>

namespace palpate
{
/// The choice in a sentence: what is chosen, its error, why nothing simpler, and where the law does
/// not hold. `before`: numbers per point of the original.
PALPATE_EXPORT std::string choiceReason(
  const ResponseChoice& choice, const ChoiceSettings& settings, int before);
} // namespace palpate

#endif
