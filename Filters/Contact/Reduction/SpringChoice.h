// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SpringChoice_h
#define palpate_SpringChoice_h

#include "Contact/Reduction/ReducibleCurves.h"
#include "Contact/Reduction/ResponseChoice.h"

namespace palpate
{
/// Takes a spring per point, where the evidence allows a point force and the springs lose no more
/// than the tolerance at the share of the points. Notes what is found either way.
bool chooseSprings(ResponseChoice& choice, const ResponseArrays& arrays,
  const ReducibleCurves& curves, const ChoiceSettings& settings);
} // namespace palpate

#endif
