// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DataEnd_h
#define palpate_DataEnd_h

#include "Mechanics/PalpateExport.h"
#include "Contact/ResponseSampling.h"

namespace palpate
{
/// The range of a body's measurement: the largest force and stiffness of any tool at the site.
struct DataEnd
{
  double force;     ///< N
  double stiffness; ///< N/mm
};

/**
 * The depth, mm, at which a stored curve exceeds the measured range; +inf if it never does.
 *
 * The depths of two tools cannot be compared. The global deflection depends on the force. The size
 * of the strained region depends on the contact radius a. At one point of a half-space or a layer
 * dF/dδ_local depends on a alone, for any tool. The same holds for dF/dδ in series with a
 * compliance. So equal stiffness means equal contact radius, and the data end at the measured force
 * or at the measured stiffness, whichever comes first.
 *
 * `force` and `stiffness` are the n samples of the curve. A tolerance of 1e-3 allows for storage.
 */
PALPATE_EXPORT double depthOfDataEnd(const ResponseSampling& sampling, double range,
  const float* force, const float* stiffness, const DataEnd& end);
} // namespace palpate

#endif
