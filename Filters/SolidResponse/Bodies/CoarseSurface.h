// SPDX-License-Identifier: BSD-3-Clause
#ifndef CoarseSurface_h
#define CoarseSurface_h

#include "vtkSmartPointer.h"

class vtkPolyData;

namespace palpate
{
/// The outside of a closed surface without detail below `voxel` (mm): closed, of even triangles,
/// nowhere crossing itself, whatever the input. A place is inside if a ray from it crosses the
/// surface an odd number of times.
vtkSmartPointer<vtkPolyData> coarseSurface(vtkPolyData* body, double voxel);
} // namespace palpate

#endif
