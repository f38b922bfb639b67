// SPDX-License-Identifier: BSD-3-Clause
#ifndef ChosenTip_h
#define ChosenTip_h

#include "Laws/ContactField.h"

#include <string>

class vtkPolyData;

namespace palpate
{
class Ranks;

/// The contact of one tip among those of all ranks.
struct ChosenTip
{
  FieldContact contact; ///< without contact, or without tips, its cell is -1
  int rank = 0;         ///< that has the cell
};

/**
 * Finds tip `index` (-1: the last) among the outputs of vtkToolContactProbe on all ranks, counted
 * rank by rank. Collective; returns what is missing or wrong, the same on all ranks, or "".
 */
std::string chooseTip(const Ranks& ranks, vtkPolyData* tips, vtkIdType index, ChosenTip& chosen);
} // namespace palpate

#endif
