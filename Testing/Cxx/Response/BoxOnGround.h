// SPDX-License-Identifier: BSD-3-Clause
#ifndef BoxOnGround_h
#define BoxOnGround_h

#include "vtkCubeSource.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTriangleFilter.h"

namespace palpate::testing
{
/// A box of triangles that stands on z = 0 with its middle on the z axis; sides in mm.
inline vtkSmartPointer<vtkPolyData> boxOnGround(double x, double y, double z)
{
  vtkNew<vtkCubeSource> source;
  source->SetXLength(x);
  source->SetYLength(y);
  source->SetZLength(z);
  source->SetCenter(0.0, 0.0, 0.5 * z);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(source->GetOutputPort());
  triangles->Update();
  return triangles->GetOutput();
}
} // namespace palpate::testing

#endif
