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

/// How a body is viewed, and which part of it is in the picture. Default: all of it, from far away
/// along +z, y up.
struct Sight
{
  Vector3 towards = Vector3::UnitZ(); ///< from the body to the viewer, not zero
  Vector3 up = Vector3::UnitY();      ///< in the picture; its part along `towards` is ignored
  Vector3 eye = Vector3::Zero();      ///< of the viewer, mm; any point of the axis for a far one
  bool isNear = false;                ///< whether lines of sight meet in the eye (perspective)
  /// Half of the picture's size: mm for a far viewer, tangents of its angles for a near one. 0: all
  /// is in it.
  double halfWidth = 0.0;
  double halfHeight = 0.0;
};

/**
 * Where a touch of the response begins: the best of 25 x 25 visible places of the body, evenly over
 * the part of the picture that it fills, by the product of
 * - flatness: the agreement of the facets' normals there and at eight places around, two contact
 *   radii away; a place on another part of the surface counts as none;
 * - the fraction of half of Range within the response's validity;
 * - facing the viewer: best when the normal leans 39 degrees up in the picture, so that force and
 *   tool are not seen from their ends;
 * - nearness to the middle of the visible part (a half at its corners). So neither the size of the
 * triangles nor a thin tail decides. If nothing with a response is in the picture, the whole body
 * is viewed from the same direction, then along the axes. Cell -1 if it has no response anywhere.
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
