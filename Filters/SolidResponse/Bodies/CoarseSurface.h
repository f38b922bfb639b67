// SPDX-License-Identifier: BSD-3-Clause
#ifndef CoarseSurface_h
#define CoarseSurface_h

#include "vtkSmartPointer.h"

class vtkPolyData;

namespace palpate
{
/// Creates a surface of the body without details smaller than `voxel` (mm). For any input, the
/// result is closed, has triangles of similar size, and does not intersect itself. A position
/// counts as inside if a ray from it crosses the surface an odd number of times.
vtkSmartPointer<vtkPolyData> coarseSurface(vtkPolyData* body, double voxel);
} // namespace palpate

#endif
