// SPDX-License-Identifier: BSD-3-Clause
#ifndef ChosenTip_h
#define ChosenTip_h

#include "Laws/ContactField.h"

#include <string>

class vtkPolyData;

namespace palpate
{
class Ranks;

/// The contact of one tip that is chosen among the tips of all ranks.
struct ChosenTip
{
  FieldContact contact; ///< the contact; its cell is -1 without contact or without tips
  int rank = 0;         ///< rank that has the cell
};

/**
 * Finds tip number `index` (-1: the last) in the outputs of vtkToolContactProbe on all ranks. Tips
 * are counted rank by rank. Collective. Returns "" or an error message, the same on all ranks.
 */
std::string chooseTip(const Ranks& ranks, vtkPolyData* tips, vtkIdType index, ChosenTip& chosen);
} // namespace palpate

#endif
