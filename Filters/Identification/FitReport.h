// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FitReport_h
#define palpate_FitReport_h

#include "Identification/BodyIdentification.h"

#include <cstddef>
#include <string>

namespace palpate
{
/// Returns the factor (N) from a standard error per newton of noise (BodyFit::errorPerNoise) to
/// half a 95 % interval. Noise, misfit and largest force of `found` must be set. Student's t is
/// used if the noise is estimated from the data, or is less than the residual.
double intervalWidth(const BodyFit& fit, bool isNoiseGiven, const IdentifiedBody& found);

/// Returns a message that a model has no fit.
std::string noBody(const std::string& model);

/// Returns the reason why the readings of a curve do not suffice. The message includes the number
/// of readings that small strain excludes.
std::string tooFew(std::size_t readings, std::size_t of, double largestStrain);
/// Returns the number of readings that small strain excludes, in words; "" if it excludes none.
std::string leftOut(std::size_t readings, std::size_t of, double largestStrain);
/// Returns the terms of the baselines that the readings before contact do not determine, in words;
/// "" if all are determined, or if `findContact` is false.
std::string undeterminedBaseline(const BodyFit& fit, bool findContact);

/// Stores the body of a fit, with intervals of the width `width`. Returns the index of the next
/// error in BodyFit::errorPerNoise.
Eigen::Index reportBody(const BodyFit& fit, double width, bool findContact, IdentifiedBody& found);

/// Stores the end of a tool's readings, at `depth` (mm) below first contact, if its contact is
/// larger than the stored contact.
void reportEnd(const AxisymmetricTool& tool, const std::shared_ptr<const LayerKernel>& kernel,
  double depth, IdentifiedBody& found);
} // namespace palpate

#endif
