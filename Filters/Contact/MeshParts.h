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
  /// Triangles of sheets and of debris inside a closed solid. The first corner of these triangles
  /// is set to -1.
  std::vector<std::int32_t> hidden;
  /// Whether walls between two solids were left out. These solids then have open borders at the
  /// wall.
  bool hasJoined = false;
  std::string fault; ///< names the part that is not a body; "" if there is no fault
};

/**
 * Reverses the parts of a surface that are wound inward. A part is a set of triangles connected by
 * edges between two triangles; its triangles must be wound consistently (makeWindingConsistent).
 *
 * - A part that coincides with another one, triangle by triangle, is left out. The walls between
 *   two solids that touch are also left out, so that the solids enclose one body.
 * - A part is a solid if it is closed, or if the area of the caps over its holes is at most a
 *   quarter of the area of the part. The sign of its enclosed volume distinguishes inside and
 *   outside.
 * - A solid that is wound inward inside another one is a cavity and is not changed.
 * - A solid that is wound outward inside another one is a second body in the same space, which is a
 *   fault. If its volume is at most a millionth of that of the other solid, it is left out as
 *   debris.
 * - A solid without volume has two coincident sides. It is left out if its area is at most a tenth
 *   of the total area; otherwise it is a fault.
 * - Two solids that overlap are a fault.
 * - Other open parts are not changed. An open part inside a closed solid is left out, because no
 *   tool can touch it.
 *
 * `coordinates` has 3 floats per point. The cost is O(n), and one ray for each solid inside the box
 * of another solid.
 */
OrientedParts orientParts(
  const float* coordinates, std::vector<TriangleCorners>& triangles, const TriangleLinks& links);
} // namespace palpate

#endif
