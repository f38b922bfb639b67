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
  /// Largest relative change of the force on a tool by a second, equal tool with an equal force.
  /// The contact circles of both tools touch.
  double change = 0.0;
  double apart = 0.0; ///< distance of the two tools, mm
  /// Distance of two tools beyond which the change does not exceed the tolerance, mm; infinite if
  /// the deflection of the body as a whole already exceeds it.
  double reach = 0.0;
  bool isFelt = false; ///< the change exceeds the tolerance
};

/**
 * Computes the change of the force of a tool at fixed depth by another tool at the distance r, to
 * first order: K C(r), where K is the stiffness and C the compliance of CouplingTerms. The depth is
 * half of each point's range. The change is evaluated at the point where K/E* is largest.
 */
PALPATE_EXPORT CouplingNeed couplingNeed(const ResponseArrays& arrays, double tolerance);

/// Returns the need as a sentence without its full stop; "" for a response without coupling.
PALPATE_EXPORT std::string couplingReason(
  const CouplingNeed& need, const CouplingTerms& terms, double tolerance);
} // namespace palpate

#endif
