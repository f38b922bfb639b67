// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Bodies/PolygonCut.h"

#include "Mechanics/JoinedText.h"

#include "vtkCellArray.h"
#include "vtkContourTriangulator.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolygon.h"
#include "vtkTriangleFilter.h"

#include <Eigen/Geometry>

#include <cmath>

namespace palpate
{
namespace
{
using Eigen::Vector3d;

/// Returns the number of triangles into which the polygons and strips of a surface are cut.
vtkIdType triangleCountOf(vtkPolyData* surface)
{
  // A polygon or a strip of n corners has n - 2 triangles.
  return surface->GetPolys()->GetNumberOfConnectivityIds() - 2 * surface->GetNumberOfPolys() +
    surface->GetStrips()->GetNumberOfConnectivityIds() - 2 * surface->GetNumberOfStrips();
}

Vector3d cornerAt(vtkPoints* points, vtkIdType id)
{
  Vector3d place;
  points->GetPoint(id, place.data());
  return place;
}

/// Returns a vector along the normal of a polygon. The length of the vector is twice the area of
/// the polygon.
Vector3d areaOf(vtkPoints* points, vtkIdList* polygon)
{
  const Vector3d origin = cornerAt(points, polygon->GetId(0));
  Vector3d sum = Vector3d::Zero();
  for (vtkIdType i = 1; i + 1 < polygon->GetNumberOfIds(); ++i)
  {
    sum += (cornerAt(points, polygon->GetId(i)) - origin)
             .cross(cornerAt(points, polygon->GetId(i + 1)) - origin);
  }
  return sum;
}

/// Returns triangles that cover a polygon, three corners each. Returns an empty list if no such
/// triangles are found.
std::vector<vtkIdType> trianglesOf(vtkPoints* points, vtkIdList* polygon)
{
  vtkNew<vtkPolygon> cell;
  cell->Initialize(static_cast<int>(polygon->GetNumberOfIds()), polygon->GetPointer(0), points);
  vtkNew<vtkIdList> corners;
  std::vector<vtkIdType> found;
  if (cell->Triangulate(corners) != 0 &&
    corners->GetNumberOfIds() == 3 * (polygon->GetNumberOfIds() - 2))
  {
    for (const vtkIdType corner : *corners)
    {
      found.push_back(polygon->GetId(corner));
    }
    return found;
  }
  // This second method can cut polygons that touch themselves, such as a ring that is cut open
  // along a line.
  vtkNew<vtkCellArray> cells;
  vtkContourTriangulator::TriangulatePolygon(polygon, points, cells);
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (cells->InitTraversal(); cells->GetNextCell(count, ids);)
  {
    found.insert(found.end(), ids, ids + (count == 3 ? 3 : 0));
  }
  return found;
}

/// Returns whether the sum of the triangles' areas equals the area of the polygon.
bool covers(const std::vector<vtkIdType>& triangles, vtkPoints* points, const Vector3d& area)
{
  double sum = 0.0;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
  {
    const Vector3d first = cornerAt(points, triangles[i]);
    sum += (cornerAt(points, triangles[i + 1]) - first)
             .cross(cornerAt(points, triangles[i + 2]) - first)
             .norm();
  }
  // The tolerance is 1 %, because polygons of a scan are seldom flat.
  return std::abs(sum - area.norm()) <= 0.01 * area.norm();
}

/// Removes corners that repeat the previous corner. VTK's triangulator terminates the program if a
/// corner is repeated.
void dropRepeatedCorners(vtkIdList* polygon)
{
  vtkIdType kept = 0;
  for (vtkIdType i = 0; i < polygon->GetNumberOfIds(); ++i)
  {
    const vtkIdType corner = polygon->GetId(i);
    if (kept == 0 || corner != polygon->GetId(kept - 1))
    {
      polygon->SetId(kept++, corner);
    }
  }
  while (kept > 1 && polygon->GetId(kept - 1) == polygon->GetId(0))
  {
    --kept;
  }
  polygon->Resize(kept);
  polygon->SetNumberOfIds(kept);
}

/// Returns whether parts of a polygon's area cancel each other because its sides cross.
bool cancelsOut(vtkPoints* points, vtkIdList* polygon, const Vector3d& area)
{
  const Vector3d origin = cornerAt(points, polygon->GetId(0));
  double sum = 0.0;
  for (vtkIdType i = 1; i + 1 < polygon->GetNumberOfIds(); ++i)
  {
    sum += (cornerAt(points, polygon->GetId(i)) - origin)
             .cross(cornerAt(points, polygon->GetId(i + 1)) - origin)
             .norm();
  }
  return area.norm() < 1e-6 * sum;
}

/// Cuts each polygon separately. This function is used for surfaces with polygons that the VTK
/// filter drops.
vtkSmartPointer<vtkPolyData> cutEach(vtkPolyData* surface, std::string& fault)
{
  vtkPoints* points = surface->GetPoints();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdList> polygon;
  for (vtkIdType i = 0; i < surface->GetNumberOfPolys(); ++i)
  {
    surface->GetPolys()->GetCellAtId(i, polygon);
    const vtkIdType corners = polygon->GetNumberOfIds();
    dropRepeatedCorners(polygon);
    const Vector3d area =
      polygon->GetNumberOfIds() < 3 ? Vector3d::Zero().eval() : areaOf(points, polygon);
    const std::vector<vtkIdType> triangles =
      area.isZero(0.0) ? std::vector<vtkIdType>() : trianglesOf(points, polygon);
    // A polygon of four corners can be cut in two ways. Both are valid, even if the polygon is not
    // flat.
    const bool isCut = polygon->GetNumberOfIds() > 4 ? covers(triangles, points, area)
                                                     : area.isZero(0.0) || !triangles.empty();
    if (polygon->GetNumberOfIds() > 3 && (!isCut || cancelsOut(points, polygon, area)))
    {
      fault = joined("polygon ", i, " of ", corners,
        " corners cannot be cut into triangles: do its sides cross?");
      return nullptr;
    }
    for (std::size_t k = 0; k + 2 < triangles.size(); k += 3)
    {
      cells->InsertNextCell(3, triangles.data() + k);
    }
  }
  vtkNew<vtkTriangleFilter> strips;
  vtkNew<vtkPolyData> others;
  others->SetPoints(points);
  others->SetStrips(surface->GetStrips());
  strips->SetInputData(others);
  strips->Update();
  cells->Append(strips->GetOutput()->GetPolys());
  auto made = vtkSmartPointer<vtkPolyData>::New();
  made->SetPoints(points);
  made->SetPolys(cells);
  made->GetPointData()->ShallowCopy(surface->GetPointData());
  made->SetFieldData(surface->GetFieldData());
  return made;
}
} // namespace

vtkSmartPointer<vtkPolyData> cutPolygons(
  vtkPolyData* surface, std::vector<std::string>& notes, std::string& fault)
{
  const vtkIdType strips = surface->GetNumberOfStrips();
  const vtkIdType others = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  const bool polygons =
    surface->GetNumberOfPolys() > 0 && surface->GetPolys()->IsHomogeneous() != 3;
  if (!polygons && strips + others == 0)
  {
    return surface;
  }
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(surface);
  filter->PassVertsOff();
  filter->PassLinesOff();
  filter->Update();
  vtkSmartPointer<vtkPolyData> made = filter->GetOutput();
  if (made->GetNumberOfPolys() != triangleCountOf(surface))
  {
    made = cutEach(surface, fault);
  }
  if (made && (polygons || strips > 0))
  {
    notes.push_back(joined(surface->GetNumberOfPolys(), " polygons and ", strips,
      " strips cut into ", made->GetNumberOfPolys(), " triangles"));
  }
  if (others > 0)
  {
    notes.push_back(joined(others, " vertices and lines left out"));
  }
  return made;
}
} // namespace palpate
