// SPDX-License-Identifier: BSD-3-Clause
#ifndef DentedBody_h
#define DentedBody_h

#include "Contact/TriangleProjection.h" // For palpate::Vector3

class vtkFloatArray;
class vtkPolyData;

namespace palpate
{
/**
 * Moves the points of a body by `displacement` (mm, one vector per point) and adds the point array
 * `Dent (mm)`: how far each has gone against `normal`, the contact's; it becomes the active
 * scalars.
 *
 * `body` shares its arrays with others: what changes is replaced, nothing is written to. Active
 * point normals are corrected where the surface has turned: by the change of the mean of the
 * facets around a point, so that smooth shading and sharp edges stay as they were.
 */
void dentBody(vtkPolyData* body, vtkFloatArray* displacement, const Vector3& normal);
} // namespace palpate

#endif
