// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Bodies/SurfaceTriangles.h"

#include "Response/BodyConversion.h"
#include "Response/Bodies/SurfaceFlaps.h"
#include "Mechanics/JoinedText.h"

#include "vtkAppendFilter.h"
#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStaticCleanPolyData.h"
#include "vtkStructuredGrid.h"
#include "vtkTriangleFilter.h"
#include "vtkTrivialProducer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace palpate
{
namespace
{
/** Finds cells that name missing points, which would crash the filters; "" if there are none. */
std::string cellFault(vtkDataSet* data)
{
  std::vector<vtkCellArray*> arrays;
  if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    arrays = { surface->GetVerts(), surface->GetLines(), surface->GetPolys(),
      surface->GetStrips() };
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    arrays = { grid->GetCells() };
  }
  for (vtkCellArray* cells : arrays)
  {
    if (cells && cells->GetNumberOfConnectivityIds() > 0)
    {
      double ids[2];
      cells->GetConnectivityArray()->GetRange(ids);
      const double wrong = ids[0] < 0 ? ids[0] : ids[1];
      if (!cells->IsValid() || wrong < 0 || wrong >= static_cast<double>(data->GetNumberOfPoints()))
      {
        return joined("its cells are damaged: one names point ", static_cast<vtkIdType>(wrong),
          ", there are ", data->GetNumberOfPoints(), " points");
      }
    }
  }
  return "";
}

/** How many coordinates are not finite, and where; "" if none. */
std::string coordinateFault(vtkDataSet* data)
{
  if (vtkImageData::SafeDownCast(data))
  {
    return ""; // an image has no coordinates but origin and spacing
  }
  vtkIdType count = 0;
  vtkIdType first = -1;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double p[3];
    data->GetPoint(i, p);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      first = count++ == 0 ? i : first;
    }
  }
  return count == 0
    ? ""
    : joined(count, " of ", data->GetNumberOfPoints(),
        " points have a coordinate that is not a finite number, the first is point ", first);
}

bool isStructured(vtkDataSet* data)
{
  return vtkImageData::SafeDownCast(data) || vtkRectilinearGrid::SafeDownCast(data) ||
    vtkStructuredGrid::SafeDownCast(data);
}

/** Merges exactly coincident points. */
vtkSmartPointer<vtkPolyData> mergedPoints(vtkPolyData* surface)
{
  vtkNew<vtkStaticCleanPolyData> clean;
  clean->SetInputData(surface);
  clean->ToleranceIsAbsoluteOn();
  clean->SetAbsoluteTolerance(0.0);
  clean->Update();
  return clean->GetOutput();
}

/** The outer surface of a volume; the faces of a shell. */
vtkSmartPointer<vtkPolyData> outerSurface(vtkDataSet* data, const int* wholeExtent)
{
  vtkNew<vtkTrivialProducer> source;
  source->SetOutput(data);
  if (wholeExtent)
  {
    source->SetWholeExtent(wholeExtent[0], wholeExtent[1], wholeExtent[2], wholeExtent[3],
      wholeExtent[4], wholeExtent[5]);
  }
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputConnection(source->GetOutputPort());
  surface->DelegationOff(); // the delegate's order of points depends on the number of threads
  surface->Update();
  // The six sides of a structured grid have their own points along the edges where they meet.
  if (isStructured(data))
  {
    return mergedPoints(surface->GetOutput());
  }
  return surface->GetOutput();
}

/** Cuts a surface into triangles; one of triangles alone is returned itself. */
vtkSmartPointer<vtkPolyData> cut(vtkPolyData* surface, std::vector<std::string>& notes)
{
  const vtkIdType strips = surface->GetNumberOfStrips();
  const vtkIdType others = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  const bool polygons =
    surface->GetNumberOfPolys() > 0 && surface->GetPolys()->IsHomogeneous() != 3;
  if (!polygons && strips + others == 0)
  {
    return surface;
  }
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(surface);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  if (polygons || strips > 0)
  {
    notes.push_back(joined(surface->GetNumberOfPolys(), " polygons and ", strips,
      " strips cut into ", triangles->GetOutput()->GetNumberOfPolys(), " triangles"));
  }
  if (others > 0)
  {
    notes.push_back(joined(others, " vertices and lines left out"));
  }
  return triangles->GetOutput();
}

/** Appends surfaces, without ghost cells. */
vtkSmartPointer<vtkPolyData> appendSurfaces(const std::vector<vtkDataSet*>& pieces)
{
  vtkNew<vtkAppendPolyData> all;
  for (vtkDataSet* piece : pieces)
  {
    vtkNew<vtkPolyData> own;
    own->ShallowCopy(piece);
    own->RemoveGhostCells();
    all->AddInputData(own);
  }
  all->Update();
  return mergedPoints(all->GetOutput());
}

/** Appends volumes, without ghost cells, since separate surfaces would have walls at the seams. */
vtkSmartPointer<vtkUnstructuredGrid> appendVolumes(const std::vector<vtkDataSet*>& pieces)
{
  vtkNew<vtkAppendFilter> all;
  all->MergePointsOn(); // which it does only where nothing is marked as a ghost
  for (vtkDataSet* piece : pieces)
  {
    vtkNew<vtkAppendFilter> unstructured;
    unstructured->AddInputData(piece);
    unstructured->Update();
    vtkUnstructuredGrid* own = unstructured->GetOutput();
    own->RemoveGhostCells();
    own->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
    own->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
    all->AddInputData(own);
  }
  all->Update();
  return all->GetOutput();
}

/** The advice for data with points but no triangles. */
std::string withoutTriangles(const std::vector<vtkDataSet*>& pieces)
{
  vtkIdType points = 0;
  bool lines = false;
  for (vtkDataSet* piece : pieces)
  {
    points += piece->GetNumberOfPoints();
    for (vtkIdType i = 0; i < piece->GetNumberOfCells() && !lines; ++i)
    {
      lines = piece->GetCell(i)->GetCellDimension() == 1;
    }
  }
  return lines
    ? joined("it holds no triangles, only lines (", points,
        " points): make a surface of them first, with Tube (vtkTubeFilter) or Ribbon "
        "(vtkRibbonFilter)")
    : joined("it holds no triangles, only ", points,
        " points: make a surface of them first, with Delaunay 3D (vtkDelaunay3D) or, of a height "
        "field, Delaunay 2D (vtkDelaunay2D)");
}
} // namespace

//------------------------------------------------------------------------------
SurfaceTriangles extractSurface(const std::vector<vtkDataSet*>& pieces, const int* wholeExtent)
{
  SurfaceTriangles result;
  for (vtkDataSet* piece : pieces)
  {
    result.fault = cellFault(piece);
    if (result.fault.empty())
    {
      result.fault = coordinateFault(piece);
    }
    if (!result.fault.empty())
    {
      return result;
    }
  }
  if (pieces.size() > 1)
  {
    result.notes.push_back(joined(pieces.size(), " partitions joined"));
  }

  result.isOfVolume = !std::all_of(pieces.begin(), pieces.end(),
    [](vtkDataSet* piece) { return vtkPolyData::SafeDownCast(piece) != nullptr; });
  if (!result.isOfVolume)
  {
    result.surface = vtkPolyData::SafeDownCast(pieces.front());
    if (pieces.size() > 1)
    {
      result.surface = appendSurfaces(pieces);
    }
    return result;
  }
  vtkSmartPointer<vtkDataSet> volume = pieces.front();
  if (pieces.size() > 1)
  {
    volume = appendVolumes(pieces);
    wholeExtent = nullptr;
  }
  result.surface = outerSurface(volume, wholeExtent);
  result.notes.push_back(joined("surface extracted from ", volume->GetNumberOfCells(), " cells"));
  return result;
}

//------------------------------------------------------------------------------
void cutSurface(SurfaceTriangles& made, const std::vector<vtkDataSet*>& pieces)
{
  made.surface = cut(made.surface, made.notes);
  if (made.surface->GetNumberOfPolys() == 0)
  {
    made.surface = nullptr;
    made.fault = withoutTriangles(pieces);
    made.isEmpty = true;
    return;
  }
  if (!made.isOfVolume)
  {
    const vtkIdType all = made.surface->GetNumberOfPolys();
    made.surface = withoutFlaps(made.surface);
    const vtkIdType leftOut = all - made.surface->GetNumberOfPolys();
    if (leftOut > 0)
    {
      made.notes.push_back(
        joined(leftOut, " triangles that occur twice, or with their reverse, left out"));
    }
  }
}

//------------------------------------------------------------------------------
std::string arraysNotShared(const std::vector<vtkDataSet*>& pieces)
{
  std::set<std::string> names;
  for (vtkDataSet* piece : pieces)
  {
    for (int i = 0; i < piece->GetPointData()->GetNumberOfArrays(); ++i)
    {
      const char* name = piece->GetPointData()->GetArrayName(i);
      names.insert(name ? name : "");
    }
  }
  std::string list;
  for (const std::string& name : names)
  {
    const bool everywhere = std::all_of(pieces.begin(), pieces.end(),
      [&name](vtkDataSet* piece) { return piece->GetPointData()->HasArray(name.c_str()) != 0; });
    if (!name.empty() && name != vtkDataSetAttributes::GhostArrayName() && !everywhere)
    {
      list += (list.empty() ? "" : ", ") + name;
    }
  }
  return list;
}

//------------------------------------------------------------------------------
bool isInsideOut(vtkPolyData* surface)
{
  const BodyMesh mesh = makeBodyMesh(surface);
  return mesh.isClosed() && mesh.enclosedVolume() < 0.0;
}
} // namespace palpate
