// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_benchmarks_DrawnBody_h
#define palpate_benchmarks_DrawnBody_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace palpate::benchmarks
{
/// The bumpy sphere of the other benchmarks (Testing/Cxx/Contact/BumpySphere.h) as VTK draws it,
/// with point normals and about `triangles` triangles.
vtkSmartPointer<vtkPolyData> drawnBody(double triangles);
} // namespace palpate::benchmarks

#endif
