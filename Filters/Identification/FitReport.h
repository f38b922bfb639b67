// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FitReport_h
#define palpate_FitReport_h

#include "Identification/BodyIdentification.h"

#include <cstddef>
#include <string>

namespace palpate
{
/// Returns the factor (N) that converts a standard error per newton of noise
/// (BodyFit::errorPerNoise) to half a 95 % interval. Noise, misfit and largest force of `found`
/// must be set. Student's t is used if the noise is estimated from the data, or is smaller than the
/// residual.
double intervalWidth(const BodyFit& fit, bool isNoiseGiven, const IdentifiedBody& found);

/// Returns a message that the fit of a model has failed.
std::string noBody(const std::string& model);

/// Returns a message that the readings of a curve do not suffice: `readings` remain of `of`
/// readings. The message includes the number of readings excluded because of their strain.
std::string tooFew(std::size_t readings, std::size_t of, double largestStrain);
/// Returns the number of readings excluded because of their strain, in words; "" if none are
/// excluded.
std::string leftOut(std::size_t readings, std::size_t of, double largestStrain);
/// Returns the terms of the baselines that the readings before contact do not determine, in words;
/// "" if all terms are determined, or if `findContact` is false.
std::string undeterminedBaseline(const BodyFit& fit, bool findContact);

/// Stores the body of a fit in `found`, with intervals of the width `width`. Returns the index of
/// the next error in BodyFit::errorPerNoise.
Eigen::Index reportBody(const BodyFit& fit, double width, bool findContact, IdentifiedBody& found);

/// Stores the contact of a tool at the end of its readings, at `depth` (mm) below first contact, if
/// this contact is larger than the stored contact.
void reportEnd(const AxisymmetricTool& tool, const std::shared_ptr<const LayerKernel>& kernel,
  double depth, IdentifiedBody& found);
} // namespace palpate

#endif
