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

/// Whether `wanted` is `known` with another Poisson's ratio (and perhaps modulus), and all forces
/// are proportional to E/(1 - ν²): the body is a half-space at small strain. Errors and validities
/// are not proportional.
bool isPoissonChange(const MadeResponses& known, const ResponseRequest& wanted);

/// The responses of `known` for the material of `wanted`, scaled instead of computed; with another
/// Poisson's ratio they are preliminary. The requests must have passed isModulusChange() or
/// isPoissonChange(). Cost: some ms for 10⁵ points. Stops when goOn() returns false.
MadeResponses scaleForces(const MadeResponses& known, const ResponseRequest& wanted,
  const std::function<bool(double)>& goOn);
} // namespace palpate

#endif
