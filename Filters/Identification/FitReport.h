// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FitReport_h
#define palpate_FitReport_h

#include "Identification/BodyIdentification.h"

#include <cstddef>
#include <string>

namespace palpate
{
/// Ratio of half a 95 % interval to a standard error per newton of noise, N. Noise, misfit and
/// largest force of `found` must be set. Student's t is used if the noise is estimated from the
/// data, or is less than the residual.
double intervalWidth(const BodyFit& fit, bool isNoiseGiven, const IdentifiedBody& found);

/// The reason why a model has no fit.
std::string noBody(const std::string& model);

/// The reason why the readings of a curve do not suffice; it includes the number of readings that
/// small strain excludes.
std::string tooFew(std::size_t readings, std::size_t of, double largestStrain);
/// The number of readings that small strain excludes, in words; "" if none are excluded.
std::string leftOut(std::size_t readings, std::size_t of, double largestStrain);
/// The terms of the curves' baselines that the readings before contact do not determine, in words.
/// "" if all are determined, or if `findContact` is false.
std::string undeterminedBaseline(const BodyFit& fit, bool findContact);

/// Stores the body of a fit, with intervals of the width `width`. Returns the index of the next
/// error of the fit.
Eigen::Index reportBody(const BodyFit& fit, double width, bool findContact, IdentifiedBody& found);

/// Stores the end of a tool's readings, at `depth` (mm) below first contact, if it is the largest
/// contact so far.
void reportEnd(const AxisymmetricTool& tool, const std::shared_ptr<const LayerKernel>& kernel,
  double depth, IdentifiedBody& found);
} // namespace palpate

#endif
