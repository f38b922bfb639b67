// SPDX-License-Identifier: BSD-3-Clause
#ifndef VolumeConversion_h
#define VolumeConversion_h

#include "Solids/FiniteElements/ElasticBody.h"

#include "vtkType.h"

#include <string>

class vtkDataArray;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace palpate
{
/// Copies nodes and elements of a grid to `mesh`. Returns "", or a message with id and type of a
/// cell that is not a hexahedron, voxel, linear or quadratic tetrahedron.
std::string convertVolume(vtkUnstructuredGrid* grid, VolumeMesh& mesh);

/// Reads the point array `Fixed`. Returns "", or a message about the fault of the array.
std::string convertFixed(vtkUnstructuredGrid* grid, std::vector<unsigned char>& fixed);

/// Returns E and ν per cell. Without an array (null) the constant is used.
std::vector<ElasticMaterial> convertMaterials(
  vtkIdType cells, vtkDataArray* young, vtkDataArray* poisson, const ElasticMaterial& constant);

/// Copies the points and triangles of the surface to `output`, with the grid's point arrays and
/// `OriginalPointIds`.
void convertSurface(const BodySurface& surface, vtkUnstructuredGrid* grid, vtkPolyData* output);
} // namespace palpate

#endif
