// SPDX-License-Identifier: BSD-3-Clause
#ifndef ModulusChange_h
#define ModulusChange_h

#include "Interaction/Session/ResponseMaker.h"

#include <functional>

namespace palpate
{
/// Whether two requests ask for the same responses of the same body.
bool areEqual(const ResponseRequest& one, const ResponseRequest& other);

/// Whether `wanted` is `known` with another Young's modulus, and all forces are proportional to
/// this modulus: the body has no material with a modulus of its own (layers below, half-space below
/// the layers, a compliance that stays), and contacts are not coupled.
bool isModulusChange(const ResponseRequest& known, const ResponseRequest& wanted);

/// The responses of `known` for the modulus of `wanted`, scaled instead of computed. The requests
/// must have passed isModulusChange(). Cost: some ms for 10⁵ points. Stops when goOn() returns
/// false.
MadeResponses scaleModulus(const MadeResponses& known, const ResponseRequest& wanted,
  const std::function<bool(double)>& goOn);
} // namespace palpate

#endif
