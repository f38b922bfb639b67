// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MeshConversion_h
#define palpate_MeshConversion_h

#include "SolidResponse/Mesher/CurvedTetrahedra.h"
#include "SolidResponse/Mesher/SpacingGrid.h"

#include "vtkSmartPointer.h"

class vtkPolyData;
class vtkUnstructuredGrid;

namespace palpate
{
/// Conversion between vtkPolyData and MeshedSurface. Only points and triangles are converted.
MeshedSurface convertSurfaceToMesh(vtkPolyData* surface);
vtkSmartPointer<vtkPolyData> convertMeshToSurface(const MeshedSurface& mesh);

void convertTetrahedra(const CurvedTetrahedra& curved, vtkUnstructuredGrid* output);
} // namespace palpate

#endif
