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

/// The view of a body, and the visible part of the picture. Default: the whole body, seen from a
/// far point along +z, with y up.
struct Sight
{
  Vector3 towards = Vector3::UnitZ(); ///< direction from the body to the viewer, not zero
  /// Upward direction in the picture. Its component along `towards` is ignored.
  Vector3 up = Vector3::UnitY();
  /// Position of the viewer, mm. For a far viewer, any point of the central line of sight.
  Vector3 eye = Vector3::Zero();
  bool isNear = false; ///< perspective view: the lines of sight meet at the eye
  /// Half of the picture's size: mm for a far viewer, tangents of the half angles for a near
  /// viewer. 0: the whole body is in the picture.
  double halfWidth = 0.0;
  double halfHeight = 0.0;
};

/**
 * Finds the start of a touch of the response: the best of 25 x 25 visible places of the body,
 * evenly spaced over the part of the picture that the body fills. Places are rated by the product
 * of
 * - flatness: the agreement of the facets' normals at the place and at eight places around it, two
 *   contact radii away; a place on another part of the surface does not contribute;
 * - the fraction of half of Range that is within the response's validity;
 * - facing the viewer: best if the normal leans 39 degrees up in the picture, so that force and
 *   tool are not seen from their ends;
 * - nearness to the middle of the visible part (one half at its corners). So neither the size of
 *   the triangles nor a thin tail determines the place.
 *
 * If the picture shows no part of the body with a response, the whole body is viewed from the same
 * direction, then along the axes. The cell is -1 if the body has no response at all.
 *
 * Cost: 0.17 s on one processor for a ball of 28 thousand triangles, including the locator.
 */
TouchedPlace findTouchStart(TouchedBody& body, vtkContactTool* tool, const Sight& sight);

/// As above, for a body with the response `name`. The tool is the one that the response names. The
/// cell is -1 also if the body has no such response.
PALPATERESPONSE_EXPORT TouchedPlace findTouchStart(
  vtkPolyData* body, const std::string& name, const Sight& sight);
} // namespace palpate

#endif
