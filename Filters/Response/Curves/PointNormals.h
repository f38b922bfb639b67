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
 * The active point normals, normalised, if the body has them; otherwise angle-weighted ones. Sets
 * status NotFinite where the coordinates or the normal are not finite, Degenerate where the normal
 * is zero, and Valid elsewhere; the normal is (0,0,0) where the status is not Valid. Returns an
 * error, or "": a closed surface without normals that winds inward.
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
