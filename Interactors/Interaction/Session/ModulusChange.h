// SPDX-License-Identifier: BSD-3-Clause
#ifndef ModulusChange_h
#define ModulusChange_h

#include "Interaction/Session/ResponseMaker.h"

#include <functional>

namespace palpate
{
/// Whether two requests are for the same responses of the same body.
bool areEqual(const ResponseRequest& one, const ResponseRequest& other);

/// Whether `wanted` differs from `known` only in Young's modulus, and all forces are proportional
/// to this modulus. They are not proportional if the body has another modulus (deeper layers, a
/// half-space below the layers, a compliance that does not change), or if contacts are coupled.
bool isModulusChange(const ResponseRequest& known, const ResponseRequest& wanted);

/// Whether `wanted` differs from `known` only in Poisson's ratio (and possibly Young's modulus),
/// and all forces are proportional to E/(1 - ν²). This holds for a half-space at small strain.
/// Errors and validities are not proportional.
bool isPoissonChange(const MadeResponses& known, const ResponseRequest& wanted);

/// Returns the responses of `known`, scaled to the material of `wanted`. If Poisson's ratio
/// differs, the result is preliminary. The requests must have passed isModulusChange() or
/// isPoissonChange(). The cost is a few ms for 10⁵ points. The function stops when goOn() returns
/// false.
MadeResponses scaleForces(const MadeResponses& known, const ResponseRequest& wanted,
  const std::function<bool(double)>& goOn);
} // namespace palpate

#endif
