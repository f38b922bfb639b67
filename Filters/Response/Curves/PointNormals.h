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
 * Unit outward normals of the points of a body, and which points cannot have a response.
 *
 * They are angle-weighted. The active point normals are used instead, since they can be more exact,
 * if each of them is within 2 degrees, and the turn to the next points, of the angle-weighted one.
 * Sets status NotFinite where the coordinates are not finite, Degenerate where no triangle with an
 * area meets, and Valid elsewhere; the normal is (0,0,0) where the status is not Valid. Returns an
 * error, or "": a closed surface in pieces that winds inward.
 *
 * `body` may be a piece: at the seam the triangles of all pieces count. Collective then, and the
 * same error comes back on all ranks.
 */
std::string fillPointNormals(
  vtkPolyData* body, const BodySeam& seam, vtkFloatArray* normals, vtkUnsignedCharArray* status);

/// The same of a whole body.
PALPATERESPONSE_EXPORT std::string fillPointNormals(
  vtkPolyData* body, vtkFloatArray* normals, vtkUnsignedCharArray* status);
} // namespace palpate

#endif
