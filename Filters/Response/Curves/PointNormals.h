// SPDX-License-Identifier: BSD-3-Clause
#ifndef PointNormals_h
#define PointNormals_h

#include "palpateResponseModule.h"

#include <string>

class vtkFloatArray;
class vtkPolyData;
class vtkUnsignedCharArray;

namespace palpate
{
class BodySeam;

/**
 * Computes unit outward normals at the points of a body, and the status of each point.
 *
 * The normals are angle-weighted. The active point normals are used instead if each of them agrees
 * with the angle-weighted normal within 2 degrees plus the largest angle to the normals of the
 * neighbouring points. Stored normals can be more exact than angle-weighted normals. The status is
 * NotFinite if the coordinates are not finite, Degenerate if the point has no triangle with an
 * area, and Valid otherwise. The normal is (0,0,0) if the status is not Valid. Returns "", or an
 * error message if a closed surface in pieces winds inward.
 *
 * `body` may be a piece. At the seam the triangles of all pieces contribute. The call is then
 * collective, and all ranks return the same error.
 */
std::string fillPointNormals(
  vtkPolyData* body, const BodySeam& seam, vtkFloatArray* normals, vtkUnsignedCharArray* status);

/// Same as above, for a whole body on one process.
PALPATERESPONSE_EXPORT std::string fillPointNormals(
  vtkPolyData* body, vtkFloatArray* normals, vtkUnsignedCharArray* status);
} // namespace palpate

#endif
