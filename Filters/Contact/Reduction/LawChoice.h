// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LawChoice_h
#define palpate_LawChoice_h

#include "Contact/Reduction/ReducibleCurves.h"
#include "Contact/Reduction/ResponseChoice.h"

namespace palpate
{
/// Chooses the smallest number of laws for which the required fraction of the points is within the
/// tolerance. Returns false, with `choice` unchanged, if settings.mostLaws laws do not suffice.
bool chooseLaws(ResponseChoice& choice, const ResponseArrays& arrays, const ReducibleCurves& curves,
  const ChoiceSettings& settings);
} // namespace palpate

#endif
