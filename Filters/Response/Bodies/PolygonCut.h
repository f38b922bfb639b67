// SPDX-License-Identifier: BSD-3-Clause
#ifndef PolygonCut_h
#define PolygonCut_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace palpate
{
/// Cuts a surface into triangles. Changes and omissions are added to `notes`. A surface of
/// triangles alone is returned itself. Returns null and a fault that names the polygon if a polygon
/// cannot be cut, because its sides cross.
vtkSmartPointer<vtkPolyData> cutPolygons(
  vtkPolyData* surface, std::vector<std::string>& notes, std::string& fault);
} // namespace palpate

#endif
