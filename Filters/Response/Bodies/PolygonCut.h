// SPDX-License-Identifier: BSD-3-Clause
#ifndef PolygonCut_h
#define PolygonCut_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace palpate
{
/// Cuts a surface into triangles. Changes and omissions are added to `notes`. A surface that has
/// only triangles is returned unchanged. Returns null and a fault that names the polygon if the
/// sides of a polygon cross, so that it cannot be cut.
vtkSmartPointer<vtkPolyData> cutPolygons(
  vtkPolyData* surface, std::vector<std::string>& notes, std::string& fault);
} // namespace palpate

#endif
