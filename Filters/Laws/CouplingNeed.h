// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CouplingNeed_h
#define palpate_CouplingNeed_h

#include "Contact/ResponseField.h"
#include "Mechanics/PalpateExport.h"

#include <string>

namespace palpate
{
/// Whether a tolerance requires the coupling of a response.
struct CouplingNeed
{
  /// Largest relative change of the force by an equal tool with an equal force, whose contact
  /// circle touches that of the first.
  double change = 0.0;
  double apart = 0.0; ///< distance of these tools, mm
  /// A tool farther away than this changes the force by no more than the tolerance, mm; infinite if
  /// the deflection of the body as a whole exceeds the tolerance.
  double reach = 0.0;
  bool isFelt = false; ///< the change exceeds the tolerance
};

/**
 * The change of the force of a tool at fixed depth by another one at the distance r, to first
 * order: K C(r), where K is the stiffness and C the compliance of CouplingTerms. The depth is half
 * of each point's range. Evaluated at the point where K/E* is largest.
 */
PALPATE_EXPORT CouplingNeed couplingNeed(const ResponseArrays& arrays, double tolerance);

/// The need as a sentence without its full stop; "" for a response without coupling.
PALPATE_EXPORT std::string couplingReason(
  const CouplingNeed& need, const CouplingTerms& terms, double tolerance);
} // namespace palpate

#endif
