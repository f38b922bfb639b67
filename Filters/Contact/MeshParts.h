// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MeshParts_h
#define palpate_MeshParts_h

#include "Contact/TriangleLinks.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace palpate
{
/// Result of orientParts().
struct OrientedParts
{
  /// Triangles of sheets and of debris inside a closed solid; their first corner is now -1.
  std::vector<std::int32_t> hidden;
  /// Whether walls between two solids were left out; these solids now share open borders.
  bool hasJoined = false;
  std::string fault; ///< names the part that is not a body; "": no fault
};

/**
 * Reverses the parts of a surface that are wound inward. A part is connected by edges between two
 * triangles; its triangles are wound alike (makeWindingConsistent).
 *
 * - A part that coincides with another one, triangle by triangle, is left out. The walls between
 *   two solids that touch are left out too: the solids enclose one body.
 * - A part is a solid if it is closed, or if the caps over its holes have at most a quarter of its
 *   area. The sign of its enclosed volume distinguishes inside and outside.
 * - A solid that is wound inward inside another one is a cavity and is not changed.
 * - A solid that is wound outward inside another one is a second body in the same space: a fault.
 *   If its volume is at most a millionth of that of the other solid, it is left out as debris.
 * - A solid without volume has two coincident sides. It is left out if it has at most a tenth of
 *   the total area; otherwise it is a fault.
 * - Two solids that overlap are a fault.
 * - Other open parts are not changed. An open part inside a closed solid is left out, because no
 *   tool touches it.
 *
 * `coordinates`: 3 floats per point. O(n), and one ray for each solid inside the box of another
 * one.
 */
OrientedParts orientParts(
  const float* coordinates, std::vector<TriangleCorners>& triangles, const TriangleLinks& links);
} // namespace palpate

#endif
