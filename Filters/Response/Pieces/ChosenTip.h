// SPDX-License-Identifier: BSD-3-Clause
#ifndef ChosenTip_h
#define ChosenTip_h

#include "Laws/ContactField.h"

#include <string>

class vtkPolyData;

namespace palpate
{
class Ranks;

/// The contact of the tip that was chosen among the tips of all ranks.
struct ChosenTip
{
  FieldContact contact; ///< the contact; its cell is -1 if there is no contact or no tip
  int rank = 0;         ///< number of the rank that has the cell
};

/**
 * Finds the tip number `index` in the outputs of vtkToolContactProbe on all ranks. If `index` is
 * -1, it finds the last tip. Tips are counted rank by rank. Collective. Returns "" or an error
 * message, the same on all ranks.
 */
std::string chooseTip(const Ranks& ranks, vtkPolyData* tips, vtkIdType index, ChosenTip& chosen);
} // namespace palpate

#endif
