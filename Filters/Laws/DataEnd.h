// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DataEnd_h
#define palpate_DataEnd_h

#include "Mechanics/PalpateExport.h"
#include "Contact/ResponseSampling.h"

namespace palpate
{
/// The end of the measured range: the largest force and stiffness that were measured with any tool
/// at the site.
struct DataEnd
{
  double force;     ///< N
  double stiffness; ///< N/mm
};

/**
 * Returns the depth, mm, at which a stored curve exceeds the measured range; +inf if it never does.
 *
 * The depths of two tools cannot be compared directly, because the global deflection depends on the
 * force, and the size of the strained region depends on the contact radius a. At one point of a
 * half-space or a layer, dF/dδ_local depends only on a, for any tool. The same is true of dF/dδ in
 * series with a compliance. Therefore equal stiffness means equal contact radius. The range ends at
 * the depth of the measured force or at the depth of the measured stiffness, whichever is smaller.
 *
 * `force` and `stiffness` are the n samples of the curve. A tolerance of 1e-3 allows for storage
 * errors.
 */
PALPATE_EXPORT double depthOfDataEnd(const ResponseSampling& sampling, double range,
  const float* force, const float* stiffness, const DataEnd& end);
} // namespace palpate

#endif
