// SPDX-License-Identifier: BSD-3-Clause
#ifndef PolygonCut_h
#define PolygonCut_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace palpate
{
/// Cuts a surface into triangles. Descriptions of changes and omissions are added to `notes`. A
/// surface that has only triangles is returned unchanged. If the sides of a polygon cross, the
/// polygon cannot be cut. In this case the function returns null and a fault that names the
/// polygon.
vtkSmartPointer<vtkPolyData> cutPolygons(
  vtkPolyData* surface, std::vector<std::string>& notes, std::string& fault);
} // namespace palpate

#endif
