// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MeshRepeats_h
#define palpate_MeshRepeats_h

#include "Contact/TriangleLinks.h"

#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace palpate
{
/// Triangles that occur more than once.
struct Repeats
{
  std::size_t copies = 0;          ///< left out; one triangle of the same corners is kept
  std::set<std::int32_t> doubtful; ///< kept ones that occurred with their reverse
  std::size_t flaps = 0;           ///< of these, left out since they enclose nothing
  std::size_t sheets = 0;          ///< of the flaps, those that are no walls between two solids
};

/// Leaves out all but the first of the triangles with the same corners: their first corner is -1
/// then.
void mergeRepeats(
  std::vector<TriangleCorners>& triangles, const TriangleLinks& links, Repeats& repeats);

/// Leaves out those triangles that occurred with their reverse, patch by patch, unless they fill a
/// hole: more edges around a patch have one other triangle than not. The others are flaps, as at
/// the seams of merged scans, or walls, whose edges have two other triangles or more.
void dropFlaps(
  std::vector<TriangleCorners>& triangles, const TriangleLinks& links, Repeats& repeats);
} // namespace palpate

#endif
