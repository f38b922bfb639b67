// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FitReport_h
#define palpate_FitReport_h

#include "Identification/BodyIdentification.h"

#include <string>

namespace palpate
{
/// Ratio of half a 95 % interval to a standard error per newton of noise, N, for a body with noise,
/// misfit and largest force set: Student's t where the noise is estimated from the data, or is less
/// than the residual.
double intervalWidth(const BodyFit& fit, bool isNoiseGiven, const IdentifiedBody& found);

/// Why there is no fit of a model.
std::string noBody(const std::string& model);

/// Stores the body of a fit, with intervals of this width. Returns the index of the fit's next
/// error.
Eigen::Index reportBody(const BodyFit& fit, double width, bool findContact, IdentifiedBody& found);

/// Stores the end of a tool's readings, at this depth (mm) below its first contact with the body.
void reportEnd(const AxisymmetricTool& tool, const std::shared_ptr<const LayerKernel>& kernel,
  double depth, IdentifiedBody& found);
} // namespace palpate

#endif
