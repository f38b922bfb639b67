// SPDX-License-Identifier: BSD-3-Clause
#ifndef ContactArrow_h
#define ContactArrow_h

#include "Contact/TriangleProjection.h" // For palpate::Vector3

#include "vtkSmartPointer.h" // For vtkSmartPointer

class vtkPolyData;

namespace palpate
{
/// An arrow from `tail` along `way` (mm): triangles with outward point normals. `thickness` is the
/// shaft's diameter, mm. It is the same for arrows of any length, so that their lengths can be
/// compared. The head is at most 40 % of the length, so head and shaft of a very short arrow are
/// thinner.
vtkSmartPointer<vtkPolyData> makeContactArrow(
  const Vector3& tail, const Vector3& way, double thickness);
} // namespace palpate

#endif
