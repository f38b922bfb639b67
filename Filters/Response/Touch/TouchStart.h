// SPDX-License-Identifier: BSD-3-Clause
#ifndef TouchStart_h
#define TouchStart_h

#include "Response/Touch/TouchedPlace.h"

#include "palpateResponseModule.h" // For export macro

#include <string>

class vtkContactTool;
class vtkPolyData;

namespace palpate
{
class TouchedBody;

/// How a body is looked at, and what of it is in the picture. By default from far away along +z, y
/// up, all of it.
struct Sight
{
  Vector3 towards = Vector3::UnitZ(); ///< from the body to the viewer, not zero
  Vector3 up = Vector3::UnitY();      ///< in the picture; what of it is along `towards` is ignored
  Vector3 eye = Vector3::Zero();      ///< of the viewer, mm; any point of the axis if he is far
  bool isNear = false;                ///< whether lines of sight meet in the eye (perspective)
  /// Half of the picture: mm if he is far, tangents of its angles if he is near. 0: all is in it.
  double halfWidth = 0.0;
  double halfHeight = 0.0;
};

/**
 * Where a touch of the response begins: among 25 x 25 places of the body that are seen, evenly over
 * the part of the picture that it fills, the best by the product of
 * - how flat it is: how much the facets' normals agree, there and at eight places around, two
 *   contact radii off; a place that is not on the same ground counts as none;
 * - how much of half of Range is within the response's validity;
 * - how well it faces the viewer: best when the normal leans 39 degrees up in the picture, so that
 *   force and tool are not seen from their ends;
 * - how near it is to the middle of what is seen (a half at the corners of that).
 * So neither the size of the triangles nor a thin tail decides. A body of which nothing with a
 * response is in the picture is looked at whole, from the same direction, then along the axes. Cell
 * -1 if it has no response anywhere.
 *
 * Cost: 0.17 s of one processor on a ball of 28 thousand triangles, locator included.
 */
TouchedPlace findTouchStart(TouchedBody& body, vtkContactTool* tool, const Sight& sight);

/// The same, of a body with the response `name` and the tool it names. Cell -1 also where there is
/// no such response.
PALPATERESPONSE_EXPORT TouchedPlace findTouchStart(
  vtkPolyData* body, const std::string& name, const Sight& sight);
} // namespace palpate

#endif
