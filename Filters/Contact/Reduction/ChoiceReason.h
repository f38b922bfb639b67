// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ChoiceReason_h
#define palpate_ChoiceReason_h

#include "Mechanics/PalpateExport.h"
#include "Contact/Reduction/ResponseChoice.h"

#include <string>

namespace palpate
{
/// The choice in a sentence: what is taken, what it costs, why nothing less, and where the law that
/// was looked at does not hold. `before` is how many numbers per point there were.
PALPATE_EXPORT std::string choiceReason(
  const ResponseChoice& choice, const ChoiceSettings& settings, int before);
} // namespace palpate

#endif
