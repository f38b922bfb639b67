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
/// Copies the nodes and elements of a grid to `mesh`. Returns "", or an error message with the id
/// and the type of a cell that is not a hexahedron, a voxel, or a linear or quadratic tetrahedron.
std::string convertVolume(vtkUnstructuredGrid* grid, VolumeMesh& mesh);

/// Reads the point array `Fixed`. Returns "" or an error message.
std::string convertFixed(vtkUnstructuredGrid* grid, std::vector<unsigned char>& fixed);

/// Returns E and ν per cell. If an array is null, the constant is used.
std::vector<ElasticMaterial> convertMaterials(
  vtkIdType cells, vtkDataArray* young, vtkDataArray* poisson, const ElasticMaterial& constant);

/// Copies the points and triangles of the surface to `output`, with the grid's point arrays and
/// `OriginalPointIds`.
void convertSurface(const BodySurface& surface, vtkUnstructuredGrid* grid, vtkPolyData* output);
} // namespace palpate

#endif
