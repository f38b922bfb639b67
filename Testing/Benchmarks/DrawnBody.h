// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_benchmarks_DrawnBody_h
#define palpate_benchmarks_DrawnBody_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace palpate::benchmarks
{
/// Returns the bumpy sphere of the other benchmarks (Testing/Cxx/Contact/BumpySphere.h) in the form
/// that VTK draws, with point normals and about `triangles` triangles.
vtkSmartPointer<vtkPolyData> drawnBody(double triangles);
} // namespace palpate::benchmarks

#endif
