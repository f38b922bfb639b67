// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TiltValidity_h
#define palpate_TiltValidity_h

#include "Contact/ResponseField.h"
#include "Laws/ContactSpot.h"
#include "Mechanics/PalpateExport.h"

namespace palpate
{
class AxisymmetricTool;

/// The validity arrays of a response. They have one value per point, except for `error`, which has
/// one value per sample.
struct TrustSpans
{
  float* validity = nullptr;      ///< mm
  unsigned char* limit = nullptr; ///< codes of ResponseLimit
  float* error = nullptr;         ///< null if it is not stored
};

/**
 * Includes the error of tilts up to the largest tilt of the table (tiltError) in the validity. It
 * is the error of the equivalent profile on a layer and the error of the table on a half-space,
 * both at the contact radius that each sample has on a half-space. The error at each sample is
 * replaced by this error if it is larger than the error of the upright law. Validity ends at the
 * depth at which the error exceeds `tolerance` (> 0); its limit is then Tilt.
 *
 * `arrays` is the response with its tilt data, `spots` its material. The result is bit for bit the
 * same for any number of threads.
 */
PALPATE_EXPORT void limitByTilts(const AxisymmetricTool& tool, const ContactSpots& spots,
  const ResponseArrays& arrays, double tolerance, const TrustSpans& trust);
} // namespace palpate

#endif
