// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceFlaps_h
#define SurfaceFlaps_h

#include "vtkSmartPointer.h"

class vtkPolyData;

namespace palpate
{
/// Leaves out triangles that enclose nothing, as surfaces merged from several scans have them at
/// their seams: both of two with the same corners that face opposite ways, and all but one of those
/// that face the same way. Point ids stay. A surface of which that is more than a tenth is a sheet
/// with two sides, and is returned itself, as is one without any. `surface`: triangles alone. Cost:
/// a sort of the triangles, 0.1 s per million.
vtkSmartPointer<vtkPolyData> withoutFlaps(vtkPolyData* surface);
} // namespace palpate

#endif
