// SPDX-License-Identifier: BSD-3-Clause
#ifndef StandingSide_h
#define StandingSide_h

#include <string>

class vtkPolyData;

namespace palpate
{
/**
 * Returns the side of the bounding box on which a body stands best, as a value of FixedFaces. This
 * is the side with the largest supporting area. The supporting area is the projected area of the
 * triangles that face this side and are within 3 % of the body's extent along this axis. If several
 * sides have equal areas, the first in the order z-, y-, x-, z+, y+, x+ is chosen. An upper side
 * (+) is chosen only if its area is 1.5 times that of a lower side, because most bodies are not
 * upside down. If the supporting area is flat, only the face is held ("z-"). Otherwise the part of
 * the body within a depth (mm) from this side is held ("y-:4.5"). The depth is 3 % of the extent.
 * It is increased in steps of 3 %, up to 15 %, until the held area is a quarter of the area of the
 * bounding box. On a smaller support a body would rock.
 */
std::string standingSide(vtkPolyData* surface);
} // namespace palpate

#endif
