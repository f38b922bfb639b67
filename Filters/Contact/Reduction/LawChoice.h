// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LawChoice_h
#define palpate_LawChoice_h

#include "Contact/Reduction/ReducibleCurves.h"
#include "Contact/Reduction/ResponseChoice.h"

namespace palpate
{
/// Chooses the fewest laws that keep the tolerance at the required fraction of the points; false,
/// with the choice unchanged, if settings.mostLaws do not suffice.
bool chooseLaws(ResponseChoice& choice, const ResponseArrays& arrays, const ReducibleCurves& curves,
  const ChoiceSettings& settings);
} // namespace palpate

#endif
