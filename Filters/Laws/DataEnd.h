// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DataEnd_h
#define palpate_DataEnd_h

#include "Mechanics/PalpateExport.h"
#include "Contact/ResponseSampling.h"

namespace palpate
{
/// The range of a body's measurement: the largest force and stiffness of any tool there.
struct DataEnd
{
  double force;     ///< N
  double stiffness; ///< N/mm
};

/**
 * The depth, mm, at which a stored curve goes beyond what was measured: +inf if it does not.
 *
 * The depths of two tools cannot be compared. The global deflection depends on the force; how much
 * of the body the contact strains, on the contact radius a. At one point of a half-space or a layer
 * dF/dδ_local depends on a alone, whatever the tool, and so does dF/dδ in series with a compliance:
 * equal stiffness is equal contact radius. So the data end at the measured force or at the measured
 * stiffness, whichever comes first.
 *
 * `force` and `stiffness` are the n samples of the curve; a tolerance of 1e-3 allows for storage.
 */
PALPATE_EXPORT double depthOfDataEnd(const ResponseSampling& sampling, double range,
  const float* force, const float* stiffness, const DataEnd& end);
} // namespace palpate

#endif
