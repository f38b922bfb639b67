// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * The terms that a response stores in addition to its curves. Code that checks or lists the stored
 * terms uses this table; Response/Terms/LawTerm.h makes, reads and writes the terms.
 */
#ifndef palpate_TermTable_h
#define palpate_TermTable_h

#include "Contact/ResponseField.h"
#include "Mechanics/PalpateExport.h"

#include <array>
#include <string>

namespace palpate
{
/// A term, with its arrays and the check of its numbers.
struct TermRow
{
  ContractArray::Use use; ///< use of the term's arrays
  const char* isWrong;    ///< continues "the file ...": "has edges that cannot be used: "
  /// Checks the numbers, which the servo tick requires to be valid. Returns "" or a message; "" for
  /// a response without the term.
  std::string (*fault)(const ResponseArrays& response);
};

/// In the order in which they are read.
PALPATE_EXPORT extern const std::array<TermRow, 4> TermTable;

/// The fault of the first term that is not valid, as a clause without a subject; "" if all are
/// valid.
PALPATE_EXPORT std::string faultOfTerms(const ResponseArrays& response);
} // namespace palpate

#endif
