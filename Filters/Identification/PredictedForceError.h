// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PredictedForceError_h
#define palpate_PredictedForceError_h

#include "Identification/BodyIdentification.h"
#include "Mechanics/PalpateExport.h"

namespace palpate
{
/// Returns half the 95 % interval of the force that another tool would have on the identified body
/// at a depth (mm), relative to this force. The error has two parts: the effect of the noise, from
/// the linearised problem, and the residual of the model if this residual exceeds the noise.
/// Returns 1 if the body has no force at that depth. `kernel` is needed only for a layer. Cost:
/// four evaluations of the body.
PALPATE_EXPORT double predictedForceError(const IdentifiedBody& body, const AxisymmetricTool& tool,
  const std::shared_ptr<const LayerKernel>& kernel, double deflection);
} // namespace palpate

#endif
