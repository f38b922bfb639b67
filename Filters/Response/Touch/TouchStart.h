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

/// The viewing direction, and the visible part of the picture. By default, the whole body is seen
/// from a far point along +z, with y up.
struct Sight
{
  Vector3 towards = Vector3::UnitZ(); ///< direction from the body to the viewer, not zero
  /// Upward direction in the picture. Its component along `towards` is ignored.
  Vector3 up = Vector3::UnitY();
  /// Position of the viewer, mm. For a far viewer, it may be any point of the central line of
  /// sight.
  Vector3 eye = Vector3::Zero();
  /// Whether the view is in perspective, with lines of sight that meet at the eye.
  bool isNear = false;
  /// Half of the picture's size. For a far viewer it is in mm; for a near viewer it is the tangent
  /// of the half angle. If it is 0, the whole body is in the picture.
  double halfWidth = 0.0;
  double halfHeight = 0.0;
};

/**
 * Finds a good place on the body to begin a touch. It is the best of 25 x 25 visible places, evenly
 * spaced over the part of the picture that the body fills. Places are rated by the product of these
 * factors:
 * - flatness: the agreement of the facets' normals at the place and at eight places around it, two
 *   contact radii away. A surrounding place on another part of the surface does not contribute;
 * - validity: the fraction of the depth Range/2 that is within the response's validity;
 * - orientation: the factor is largest if the normal is tilted 39 degrees upward in the picture, so
 *   that force and tool are not seen from their ends;
 * - nearness to the middle of the visible part, with one half at the corners of this part. Because
 *   of this factor, neither the size of the triangles nor a thin tail of the body determines the
 *   place.
 *
 * If the picture shows no part of the body with a response, the whole body is viewed from the same
 * direction, then along the axes. The cell is -1 if the body has no response at all.
 *
 * Cost: 0.17 s on one processor for a ball of 28 thousand triangles, including the locator.
 */
TouchedPlace findTouchStart(TouchedBody& body, vtkContactTool* tool, const Sight& sight);

/// Same as above, for a body with the response `name`. The tool is the tool that the response
/// names. The cell is -1 also if the body does not have this response.
PALPATERESPONSE_EXPORT TouchedPlace findTouchStart(
  vtkPolyData* body, const std::string& name, const Sight& sight);
} // namespace palpate

#endif
