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
  /// Triangles of sheets and of debris inside a closed solid; first corner -1 now.
  std::vector<std::int32_t> hidden;
  /// Whether walls between two solids are left out; these solids now share open borders.
  bool hasJoined = false;
  std::string fault; ///< names the part that is not a body; "": no fault
};

/**
 * Reverses the parts of a surface that are wound inward. A part is connected across edges of two
 * triangles; neighbours are wound alike (makeWindingConsistent).
 *
 * - A part at the place of another one, triangle by triangle, is left out. So are the walls between
 *   two solids that touch: they enclose one body.
 * - A part is a solid if it is closed, or if the caps over its holes have at most a quarter of its
 *   area. The sign of its enclosed volume distinguishes inside and outside.
 * - A solid that is wound inward inside another one is a cavity, and stays as it is.
 * - A solid that is wound outward inside another one is a second body in the same place: a fault.
 *   It is left out as debris if its volume is at most a millionth of that of the other solid.
 * - A solid without volume has its two sides at one place. It is left out if it has at most a tenth
 *   of the whole area; otherwise it is a fault.
 * - Two solids that overlap are a fault.
 * - Other open parts stay as they are. An open part inside a closed solid is left out: no tool
 *   touches it.
 *
 * `coordinates`: 3 floats per point. O(n); solids inside the box of another one cost a ray each.
 */
OrientedParts orientParts(
  const float* coordinates, std::vector<TriangleCorners>& triangles, const TriangleLinks& links);
} // namespace palpate

#endif
