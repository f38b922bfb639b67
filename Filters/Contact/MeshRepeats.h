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
/// Triangles that occur more than once, also with the reverse winding.
struct Repeats
{
  /// Number of triangles left out; one triangle with the same corners is kept.
  std::size_t copies = 0;
  /// Triangles that were kept although the reverse triangle occurred.
  std::set<std::int32_t> doubtful;
  std::size_t flaps = 0;  ///< number of `doubtful` triangles left out because they enclose nothing
  std::size_t sheets = 0; ///< number of these flaps that are not walls between two solids
};

/// Of all triangles with the same corners, keeps the first. Sets the first corner of the others to
/// -1.
void mergeRepeats(
  std::vector<TriangleCorners>& triangles, const TriangleLinks& links, Repeats& repeats);

/// Leaves out the triangles of `doubtful`, patch by patch, unless the patch fills a hole. A patch
/// fills a hole if more than half of its outer edges have exactly one other triangle. The other
/// patches are flaps, as at the seams of merged scans, or walls, whose edges have at least two
/// other triangles.
void dropFlaps(
  std::vector<TriangleCorners>& triangles, const TriangleLinks& links, Repeats& repeats);
} // namespace palpate

#endif
