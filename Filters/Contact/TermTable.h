// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * The terms that a response stores in addition to its curves. Code that checks or lists the stored
 * terms uses this table. Response/Terms/LawTerm.h creates, reads and writes the terms.
 */
#ifndef palpate_TermTable_h
#define palpate_TermTable_h

#include "Contact/ResponseField.h"
#include "Mechanics/PalpateExport.h"

#include <array>
#include <string>

namespace palpate
{
/// A term, with its arrays and the check of its values.
struct TermRow
{
  ContractArray::Use use; ///< the use by which the arrays of the term are marked
  const char* isWrong;    ///< continues "the file ...": "has edges that cannot be used: "
  /// Checks the values, because the servo tick requires valid values. Returns a message, or "" if
  /// the values are valid or the response does not have the term.
  std::string (*fault)(const ResponseArrays& response);
};

/// The terms in the order in which they are read.
PALPATE_EXPORT extern const std::array<TermRow, 4> TermTable;

/// Returns the fault of the first invalid term, as a clause without a subject; "" if all terms are
/// valid.
PALPATE_EXPORT std::string faultOfTerms(const ResponseArrays& response);
} // namespace palpate

#endif
