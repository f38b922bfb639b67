// SPDX-License-Identifier: BSD-3-Clause
#ifndef ContactArrow_h
#define ContactArrow_h

#include "Contact/TriangleProjection.h" // For palpate::Vector3

#include "vtkSmartPointer.h" // For vtkSmartPointer

class vtkPolyData;

namespace palpate
{
/// Returns an arrow from `tail` along the vector `way` (mm), as triangles with outward point
/// normals. `thickness` is the diameter of the shaft, mm. Arrows of any length have the same
/// thickness, so that lengths can be compared. The head is at most 40 % of the length. Therefore a
/// very short arrow has a thinner head and shaft.
vtkSmartPointer<vtkPolyData> makeContactArrow(
  const Vector3& tail, const Vector3& way, double thickness);
} // namespace palpate

#endif
