// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FitReport_h
#define palpate_FitReport_h

#include "Mechanics/Identification/BodyIdentification.h"

namespace palpate
{
/// Half a 95 % interval over a standard error per newton of noise, N, for a body whose noise,
/// misfit and largest force are in: Student's t where the noise is taken from the data, or is less
/// than what the model leaves.
double intervalWidth(const BodyFit& fit, bool isNoiseGiven, const IdentifiedBody& found);

/// The body of a fit, with intervals of this width. The place of the next error of the fit.
Eigen::Index reportBody(const BodyFit& fit, double width, bool findContact, IdentifiedBody& found);

/// That readings of a tool end so deep (mm) below its first contact with the body that was found.
void reportEnd(const AxisymmetricTool& tool, const std::shared_ptr<const LayerKernel>& kernel,
  double depth, IdentifiedBody& found);
} // namespace palpate

#endif
