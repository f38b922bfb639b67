// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TiltValidity_h
#define palpate_TiltValidity_h

#include "Contact/ResponseField.h"
#include "Laws/ContactSpot.h"
#include "Mechanics/PalpateExport.h"

namespace palpate
{
class AxisymmetricTool;

/// Where the trust in a response lies: of each point one value, of the error as many as samples.
struct TrustSpans
{
  float* validity = nullptr;      ///< mm
  unsigned char* limit = nullptr; ///< ResponseLimit
  float* error = nullptr;         ///< null: not kept
};

/**
 * Takes into account that a tool may be tilted as far as its table goes: what the equivalent
 * profile may be off by on a layer then (tiltError), at each sample's contact radius on a
 * half-space. The larger of it and what the upright law has is the error; validity ends where it
 * passes `tolerance` (> 0), and is then limited by Tilt. Nothing changes on a half-space.
 *
 * `arrays` is the response with its tilts, `spots` its material. Safe for any number of threads of
 * its own: the same bits.
 */
PALPATE_EXPORT void limitByTilts(const AxisymmetricTool& tool, const ContactSpots& spots,
  const ResponseArrays& arrays, double tolerance, const TrustSpans& trust);
} // namespace palpate

#endif
