// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PredictedForceError_h
#define palpate_PredictedForceError_h

#include "Mechanics/Identification/BodyIdentification.h"
#include "Mechanics/PalpateExport.h"

namespace palpate
{
/// Half the 95 % interval of the force another tool meets on the identified body at a depth (mm),
/// relative: what noise leaves open, by the linearised problem, and what the model does not fit of
/// the readings where that is more than noise. At least 1 where the body has no answer. `kernel` is
/// needed for a layer only. Cost: four evaluations of the body.
PALPATE_EXPORT double predictedForceError(const IdentifiedBody& body, const AxisymmetricTool& tool,
  const std::shared_ptr<const LayerKernel>& kernel, double deflection);
} // namespace palpate

#endif
