// SPDX-License-Identifier: BSD-3-Clause
#ifndef PolygonCut_h
#define PolygonCut_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace palpate
{
/// A surface of triangles; what was cut or left out is added to `notes`. A surface of triangles
/// alone is returned itself. Null, and a fault that names the polygon, if one cannot be cut: its
/// sides cross.
vtkSmartPointer<vtkPolyData> cutPolygons(
  vtkPolyData* surface, std::vector<std::string>& notes, std::string& fault);
} // namespace palpate

#endif
