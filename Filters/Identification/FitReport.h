// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FitReport_h
#define palpate_FitReport_h

#include "Identification/BodyIdentification.h"

#include <cstddef>
#include <string>

namespace palpate
{
/// Ratio of half a 95 % interval to a standard error per newton of noise, N, for a body with noise,
/// misfit and largest force set: Student's t where the noise is estimated from the data, or is less
/// than the residual.
double intervalWidth(const BodyFit& fit, bool isNoiseGiven, const IdentifiedBody& found);

/// Why there is no fit of a model.
std::string noBody(const std::string& model);

/// Why so many readings of a curve do not suffice, and that small strain leaves out the others.
std::string tooFew(std::size_t readings, std::size_t of, double largestStrain);
/// What small strain leaves out; "" where that is nothing.
std::string leftOut(std::size_t readings, std::size_t of, double largestStrain);
/// What the readings before contact do not tell of a curve's baseline; "" where that is nothing, or
/// contact is not to be found.
std::string untoldBaseline(const BodyFit& fit, bool findContact);

/// Stores the body of a fit, with intervals of this width. Returns the index of the fit's next
/// error.
Eigen::Index reportBody(const BodyFit& fit, double width, bool findContact, IdentifiedBody& found);

/// Stores the end of a tool's readings, at this depth (mm) below its first contact with the body.
void reportEnd(const AxisymmetricTool& tool, const std::shared_ptr<const LayerKernel>& kernel,
  double depth, IdentifiedBody& found);
} // namespace palpate

#endif
