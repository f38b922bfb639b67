// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CouplingNeed_h
#define palpate_CouplingNeed_h

#include "Contact/ResponseField.h"
#include "Mechanics/PalpateExport.h"

#include <string>

namespace palpate
{
/// Whether the coupling of contacts is needed to keep the error of the force within a tolerance.
struct CouplingNeed
{
  /// Largest relative change of the force on a tool caused by a second, equal tool with an equal
  /// force, when the contact circles of the two tools touch.
  double change = 0.0;
  double apart = 0.0; ///< distance of the two tools, mm
  /// Distance of two tools beyond which the change is within the tolerance, mm; infinite if the
  /// deflection of the body as a whole already exceeds the tolerance.
  double reach = 0.0;
  bool isFelt = false; ///< whether the change exceeds the tolerance
};

/**
 * Computes the change of the force of a tool at fixed depth caused by another tool at the distance
 * r, to first order: K C(r), where K is the stiffness and C the compliance of CouplingTerms. The
 * depth is half of each point's range. The change is evaluated at the point with the largest K/E*.
 */
PALPATE_EXPORT CouplingNeed couplingNeed(const ResponseArrays& arrays, double tolerance);

/// Returns the result as a sentence without its full stop; "" for a response without coupling.
PALPATE_EXPORT std::string couplingReason(
  const CouplingNeed& need, const CouplingTerms& terms, double tolerance);
} // namespace palpate

#endif
