// SPDX-License-Identifier: BSD-3-Clause
#ifndef CoarseSurface_h
#define CoarseSurface_h

#include "vtkSmartPointer.h"

class vtkPolyData;

namespace palpate
{
/// Makes a surface of the body without details smaller than `voxel` (mm). The result is closed, has
/// triangles of similar size, and never intersects itself, whatever the input. A place counts as
/// inside if a ray from it crosses the surface an odd number of times.
vtkSmartPointer<vtkPolyData> coarseSurface(vtkPolyData* body, double voxel);
} // namespace palpate

#endif
