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
/// The displacement of a body under one contact.
struct Dent
{
  vtkSmartPointer<vtkFloatArray> displacement; ///< mm, one vector per point
  Vector3 normal = Vector3::UnitZ();           ///< normal of the contact
};

/**
 * Moves the points of a body by the sum of all dents. `dents` has at least one element. Adds two
 * point arrays: `ContactDisplacement`, the total displacement, and `Dent (mm)`, the active scalars.
 * `Dent (mm)` is the sum over all dents of the displacement component opposite to the contact
 * normal.
 *
 * Other objects share the arrays of `body`. Therefore the function replaces the arrays that change,
 * and modifies no array. Active point normals are corrected by the change of the mean normal of the
 * facets around a point, so that smooth shading and sharp edges are kept.
 */
void dentBody(vtkPolyData* body, const std::vector<Dent>& dents);
} // namespace palpate

#endif
