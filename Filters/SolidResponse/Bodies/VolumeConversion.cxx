// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/VolumeConversion.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkCellTypes.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace palpate
{
namespace
{
/// The corners of a voxel in the order of a hexahedron's corners.
constexpr std::array<int, 8> VoxelCorner = { 0, 1, 3, 2, 4, 5, 7, 6 };

bool elementKindOf(int cellType, ElementKind& kind)
{
  switch (cellType)
  {
    case VTK_HEXAHEDRON:
    case VTK_VOXEL:
      kind = ElementKind::Hexahedron;
      return true;
    case VTK_TETRA:
      kind = ElementKind::Tetrahedron;
      return true;
    case VTK_QUADRATIC_TETRA:
      kind = ElementKind::QuadraticTetrahedron;
      return true;
    default:
      return false;
  }
}
} // namespace

std::string convertVolume(vtkUnstructuredGrid* grid, VolumeMesh& mesh)
{
  std::ostringstream text;
  const vtkIdType points = grid->GetNumberOfPoints();
  const vtkIdType cells = grid->GetNumberOfCells();
  // There are three unknowns per point, and the unknowns are numbered by int.
  if (points > std::numeric_limits<int>::max() / 3 || cells > std::numeric_limits<int>::max())
  {
    text << points << " points are too many to be solved";
    return text.str();
  }
  mesh.nodes.resize(3, points);
  for (vtkIdType i = 0; i < points; ++i)
  {
    grid->GetPoint(i, mesh.nodes.data() + 3 * i);
  }
  mesh.elements.resize(static_cast<std::size_t>(cells));
  for (vtkIdType c = 0; c < cells; ++c)
  {
    const int type = grid->GetCellType(c);
    VolumeElement& element = mesh.elements[static_cast<std::size_t>(c)];
    if (!elementKindOf(type, element.kind))
    {
      const char* name = vtkCellTypes::GetClassNameFromTypeId(type);
      text << "cell " << c << " is a " << (name ? name : "cell") << " (type " << type
           << "); only VTK_HEXAHEDRON, VTK_VOXEL, VTK_TETRA and VTK_QUADRATIC_TETRA are solved for";
      return text.str();
    }
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    grid->GetCellPoints(c, count, ids);
    if (count != nodeCount(element.kind))
    {
      text << "cell " << c << " has " << count << " points instead of " << nodeCount(element.kind);
      return text.str();
    }
    for (int i = 0; i < nodeCount(element.kind); ++i)
    {
      const vtkIdType id = ids[type == VTK_VOXEL ? VoxelCorner[static_cast<std::size_t>(i)] : i];
      if (id < 0 || id >= points)
      {
        text << "cell " << c << " names point " << id << " of " << points;
        return text.str();
      }
      element.nodes[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(id);
    }
  }
  return {};
}

std::string convertFixed(vtkUnstructuredGrid* grid, std::vector<unsigned char>& fixed)
{
  std::ostringstream text;
  vtkDataArray* array = grid->GetPointData()->GetArray("Fixed");
  if (!array)
  {
    return "there is no point array 'Fixed' (bits 1, 2, 4: held along x, y, z)";
  }
  if (array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != grid->GetNumberOfPoints())
  {
    text << "point array 'Fixed' must have 1 component and " << grid->GetNumberOfPoints()
         << " tuples, but has " << array->GetNumberOfComponents() << " and "
         << array->GetNumberOfTuples();
    return text.str();
  }
  fixed.resize(static_cast<std::size_t>(grid->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const double value = array->GetComponent(i, 0);
    if (!(value >= 0.0 && value <= 7.0 && value == std::floor(value)))
    {
      text << "point array 'Fixed': the value of point " << i
           << " must be a whole number from 0 to 7, but is " << value;
      return text.str();
    }
    fixed[static_cast<std::size_t>(i)] = static_cast<unsigned char>(value);
  }
  return {};
}

std::vector<ElasticMaterial> convertMaterials(
  vtkIdType cells, vtkDataArray* young, vtkDataArray* poisson, const ElasticMaterial& constant)
{
  if (!young && !poisson)
  {
    return { constant };
  }
  std::vector<ElasticMaterial> materials(static_cast<std::size_t>(cells), constant);
  for (vtkIdType c = 0; c < cells; ++c)
  {
    ElasticMaterial& material = materials[static_cast<std::size_t>(c)];
    material.youngsModulus = young ? young->GetComponent(c, 0) : material.youngsModulus;
    material.poissonRatio = poisson ? poisson->GetComponent(c, 0) : material.poissonRatio;
  }
  return materials;
}

void convertSurface(const BodySurface& surface, vtkUnstructuredGrid* grid, vtkPolyData* output)
{
  const vtkIdType count = surface.pointTotal();
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  points->SetNumberOfPoints(count);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("OriginalPointIds");
  ids->SetNumberOfTuples(count);
  vtkPointData* from = grid->GetPointData();
  vtkPointData* to = output->GetPointData();
  to->CopyAllOn();
  to->CopyAllocate(from, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType node = surface.node(static_cast<std::int32_t>(i));
    points->SetPoint(i, surface.position(static_cast<std::int32_t>(i)).data());
    ids->SetValue(i, node);
    to->CopyData(from, node, i);
  }
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(surface.triangleTotal(), 3 * vtkIdType{ surface.triangleTotal() });
  for (std::int32_t t = 0; t < surface.triangleTotal(); ++t)
  {
    const auto& corners = surface.triangle(t);
    triangles->InsertNextCell({ corners[0], corners[1], corners[2] });
  }
  output->SetPoints(points);
  output->SetPolys(triangles);
  to->AddArray(ids);
}
} // namespace palpate
