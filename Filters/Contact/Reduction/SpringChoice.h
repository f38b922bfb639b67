// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SpringChoice_h
#define palpate_SpringChoice_h

#include "Contact/Reduction/ReducibleCurves.h"
#include "Contact/Reduction/ResponseChoice.h"

namespace palpate
{
/// Chooses a spring per point, if the evidence allows a point force and the error of the springs is
/// within the tolerance at the required fraction of the points. Sets its findings in either case.
bool chooseSprings(ResponseChoice& choice, const ResponseArrays& arrays,
  const ReducibleCurves& curves, const ChoiceSettings& settings);
} // namespace palpate

#endif
