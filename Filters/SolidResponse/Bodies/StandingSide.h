// SPDX-License-Identifier: BSD-3-Clause
#ifndef StandingSide_h
#define StandingSide_h

#include <string>

class vtkPolyData;

namespace palpate
{
/**
 * Returns the side of its bounding box on which a body stands best, as a text for FixedFaces. For
 * each side, the area of the triangles that face the side is projected along its axis; only
 * triangles whose middle is within 3 % of the body's extent from the side contribute. The side with
 * the largest area is chosen; if several are equal, the first in the order z-, y-, x-, z+, y+, x+.
 * If the area is flat, the face itself is held ("z-"); otherwise all points within that depth are
 * held ("y-:4.5").
 */
std::string standingSide(vtkPolyData* surface);
} // namespace palpate

#endif
