// SPDX-License-Identifier: BSD-3-Clause
#ifndef StandingSide_h
#define StandingSide_h

#include <string>

class vtkPolyData;

namespace palpate
{
/**
 * The side of its bounding box on which a body stands best, as a text for FixedFaces: the side
 * with the largest area that looks to it, seen along its axis, within 3 % of the body's extent. Of
 * equal sides the first in the order z-, y-, x-, z+, y+, x+. If that area is flat, the face itself
 * is held ("z-"); otherwise all within that depth ("y-:4.5").
 */
std::string standingSide(vtkPolyData* surface);
} // namespace palpate

#endif
