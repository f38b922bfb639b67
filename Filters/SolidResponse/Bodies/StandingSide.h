// SPDX-License-Identifier: BSD-3-Clause
#ifndef StandingSide_h
#define StandingSide_h

#include <string>

class vtkPolyData;

namespace palpate
{
/**
 * The side of its bounding box on which a body stands best, as a text for FixedFaces: the side with
 * the largest projected area of outward-facing triangles within 3 % of the body's extent along that
 * axis. Of equal sides the first in the order z-, y-, x-, z+, y+, x+ is chosen. An upper side (+)
 * must have 1.5 times the area of a lower one, because most bodies are not upside down. If the area
 * is flat, only the face is held ("z-"). Otherwise everything within a depth in mm is held
 * ("y-:4.5"): 3 % of the extent, or more in steps of 3 %, up to 15 %, until the held area is a
 * quarter of that of the bounding box. On a smaller support a body would rock.
 */
std::string standingSide(vtkPolyData* surface);
} // namespace palpate

#endif
