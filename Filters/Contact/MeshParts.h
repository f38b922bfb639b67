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
/// What orientParts has done.
struct OrientedParts
{
  std::size_t leftOut = 0; ///< triangles of small parts that enclose nothing; first corner -1 now
  /// Triangles of sheets inside a closed solid; first corner -1 now.
  std::vector<std::int32_t> hidden;
  /// Whether walls between two solids are left out: these share open borders now.
  bool hasJoined = false;
  std::string fault; ///< names the part that is no body; "" if there is none
};

/**
 * Reverses the parts of a surface that wind inward. A part is connected across edges of two
 * triangles; neighbours wind alike (makeWindingConsistent).
 *
 * - A part at the place of another one, triangle by triangle, is left out. So are the walls
 *   between two solids that touch: what they enclose is one body.
 * - A part is a solid if it is closed, or if caps over its holes have at most a quarter of its
 * area. Its enclosed volume tells inside from outside.
 * - A solid that winds inward inside another one is a cavity, and stays as it is.
 * - A solid that winds outward inside another one is a second body in the same place: a fault.
 * - A solid without volume has its two sides at one place. It is left out if it has at most
 *   a tenth of the whole area, and otherwise a fault.
 * - Two solids that overlap are a fault.
 * - Other open parts stay as they are. One inside a closed solid is left out: no tool touches it.
 *
 * `coordinates`: 3 floats per point. O(n); solids inside the box of another one cost a ray each.
 */
OrientedParts orientParts(
  const float* coordinates, std::vector<TriangleCorners>& triangles, const TriangleLinks& links);
} // namespace palpate

#endif
