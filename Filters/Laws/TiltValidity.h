// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TiltValidity_h
#define palpate_TiltValidity_h

#include "Contact/ResponseField.h"
#include "Laws/ContactSpot.h"
#include "Mechanics/PalpateExport.h"

namespace palpate
{
class AxisymmetricTool;

/// The validity arrays of a response: one value per point, of the error one per sample.
struct TrustSpans
{
  float* validity = nullptr;      ///< mm
  unsigned char* limit = nullptr; ///< ResponseLimit
  float* error = nullptr;         ///< null: not kept
};

/**
 * Includes the error of tilts up to the largest of the table: that of the equivalent profile on a
 * layer, and that of the table on a half-space (tiltError), at each sample's contact radius on a
 * half-space. The error is the larger of it and that of the upright law; validity ends where it
 * exceeds `tolerance` (> 0), and is then limited by Tilt.
 *
 * `arrays` is the response with its tilts, `spots` its material. The same bits for any number of
 * threads.
 */
PALPATE_EXPORT void limitByTilts(const AxisymmetricTool& tool, const ContactSpots& spots,
  const ResponseArrays& arrays, double tolerance, const TrustSpans& trust);
} // namespace palpate

#endif
