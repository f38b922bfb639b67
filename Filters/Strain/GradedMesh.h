// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_GradedMesh_h
#define palpate_GradedMesh_h

#include "Mechanics/PalpateExport.h"

#include <utility>
#include <vector>

namespace palpate
{
/// A range of a division in which no element is longer than `size`.
struct FineRange
{
  double from;
  double to;
  double size;
};

/**
 * Divides 0 ≤ x ≤ end into elements. Each element is as long as the nearby ranges allow. With
 * increasing distance from the ranges, each element is at most `growth` (> 1) times as long as the
 * preceding one. `through` has positions that must be ends of elements, ascending, within (0, end).
 * Returns all ends of elements, including 0 and `end`.
 */
PALPATE_EXPORT std::vector<double> gradedDivision(double end, const std::vector<FineRange>& fine,
  double growth, const std::vector<double>& through = {});
} // namespace palpate

#endif
