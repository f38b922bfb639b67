// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LawChoice_h
#define palpate_LawChoice_h

#include "Contact/Reduction/ReducibleCurves.h"
#include "Contact/Reduction/ResponseChoice.h"

namespace palpate
{
/// Takes the fewest laws that keep the tolerance at the share of the points; false, and the choice
/// as it was, where settings.mostLaws do not.
bool chooseLaws(ResponseChoice& choice, const ResponseArrays& arrays, const ReducibleCurves& curves,
  const ChoiceSettings& settings);
} // namespace palpate

#endif
