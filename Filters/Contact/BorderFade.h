// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BorderFade_h
#define palpate_BorderFade_h

#include "Contact/PackedMesh.h"

#include <cstdint>

namespace palpate
{
/**
 * What is left of the force on a tip that has slid off an open border.
 *
 * Beyond a border there is no surface and no depth, but a force that ends between two ticks is a
 * knock. So it fades with the place of the tip: h deep under the surface at the border and l beyond
 * it, measured within the surface, the tip keeps the fraction (1 - l/h)² (1 + 2 l/h) of the force
 * at depth h: all of it right under the border, nothing from l = h on, without a kink at either
 * end. The force stays along the surface's normal: nothing pulls the tip back to the border.
 *
 * A function of place alone, whatever the way there; continuous where the surface at the border is
 * flat or bends along it, and else but for the angle between neighbouring triangles. Energy is not
 * conserved: a tip may come in from beside without the work it takes to press.
 */
struct BorderFade
{
  double depth = 0.0;    ///< h, mm, >= 0
  double fraction = 0.0; ///< of the force at that depth, 0 to 1

  /// For a point on the border of a triangle, given by its area coordinates: one is zero on an
  /// edge, two at a corner. `offset` leads from there to the tip, on the inner side.
  static BorderFade at(const PackedMesh& mesh, std::int32_t triangle, const Vector3& weights,
    const Vector3& offset) noexcept;
};
} // namespace palpate

#endif
