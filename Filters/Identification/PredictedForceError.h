// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PredictedForceError_h
#define palpate_PredictedForceError_h

#include "Identification/BodyIdentification.h"
#include "Mechanics/PalpateExport.h"

namespace palpate
{
/// Half the 95 % interval, relative, of another tool's force on the identified body at a depth
/// (mm): by noise, from the linearised problem, and by the model's residual where that exceeds the
/// noise. At least 1 where the body has no force. `kernel` is needed for a layer only. Cost: four
/// evaluations of the body.
PALPATE_EXPORT double predictedForceError(const IdentifiedBody& body, const AxisymmetricTool& tool,
  const std::shared_ptr<const LayerKernel>& kernel, double deflection);
} // namespace palpate

#endif
