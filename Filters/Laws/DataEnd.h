// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DataEnd_h
#define palpate_DataEnd_h

#include "Mechanics/PalpateExport.h"
#include "Contact/ResponseSampling.h"

namespace palpate
{
/// How far a body was measured: the largest force and stiffness any tool met there.
struct DataEnd
{
  double force;     ///< N
  double stiffness; ///< N/mm
};

/**
 * The depth, mm, at which a stored curve goes beyond what was measured: +inf if it does not.
 *
 * One tool's depth means nothing to another. What the body gives as a whole depends on the force;
 * how much of it the contact strains, on the contact radius a. At one point of a half-space or a
 * layer dF/dδ_local depends on a alone, whatever the tool, and so does dF/dδ in series with a
 * compliance: equal stiffness is equal contact radius. So the data end at the measured force or
 * at the measured stiffness, whichever comes first.
 *
 * `force` and `stiffness` are the n samples of the curve; a part in a thousand is given for
 * storage.
 */
PALPATE_EXPORT double depthOfDataEnd(const ResponseSampling& sampling, double range,
  const float* force, const float* stiffness, const DataEnd& end);
} // namespace palpate

#endif
