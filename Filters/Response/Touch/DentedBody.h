// SPDX-License-Identifier: BSD-3-Clause
#ifndef DentedBody_h
#define DentedBody_h

#include "Contact/TriangleProjection.h" // For palpate::Vector3

#include "vtkFloatArray.h"   // For vtkFloatArray
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <vector>

class vtkPolyData;

namespace palpate
{
/// What one contact does to a body.
struct Dent
{
  vtkSmartPointer<vtkFloatArray> displacement; ///< mm, one vector per point
  Vector3 normal = Vector3::UnitZ();           ///< of the contact
};

/**
 * Moves the points of a body by what all dents make together and adds the point array `Dent (mm)`:
 * how far each has gone against the normals, by each dent along its own; it becomes the active
 * scalars. The point array `ContactDisplacement` is the whole motion. At least one dent.
 *
 * `body` shares its arrays with others: what changes is replaced, nothing is written to. Active
 * point normals are corrected where the surface has turned: by the change of the mean of the
 * facets around a point, so that smooth shading and sharp edges stay as they were.
 */
void dentBody(vtkPolyData* body, const std::vector<Dent>& dents);
} // namespace palpate

#endif
