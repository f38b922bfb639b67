// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Bodies/SurfaceTriangles.h"

#include "Response/BodyConversion.h"
#include "Response/Bodies/OuterFaces.h"
#include "Response/Bodies/PolygonCut.h"
#include "Mechanics/JoinedText.h"

#include "vtkAppendFilter.h"
#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCleanPolyData.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStaticCleanPolyData.h"
#include "vtkStaticPointLocator.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <set>
#include <utility>

namespace palpate
{
namespace
{
/**
 * Finds cells that refer to missing points. Such cells would crash the filters. Returns an error
 * message or "".
 */
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
          ", but there are ", data->GetNumberOfPoints(), " points");
      }
    }
  }
  return "";
}

/** Returns the surface with exactly coincident points merged. */
vtkSmartPointer<vtkPolyData> mergedPoints(vtkPolyData* surface)
{
  vtkNew<vtkStaticCleanPolyData> clean;
  clean->SetInputData(surface);
  clean->ToleranceIsAbsoluteOn();
  clean->SetAbsoluteTolerance(0.0);
  clean->Update();
  return clean->GetOutput();
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

/**
 * Finds points of several pieces whose positions differ only by rounding, and moves them to a
 * common position.
 */
void joinRoundedPoints(const std::vector<vtkSmartPointer<vtkUnstructuredGrid>>& pieces)
{
  constexpr double rounding = 1e-5; // tolerance as a fraction of the diagonal
  vtkNew<vtkAppendFilter> all;
  for (vtkUnstructuredGrid* piece : pieces)
  {
    all->AddInputData(piece);
  }
  all->Update();
  vtkUnstructuredGrid* whole = all->GetOutput();
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(whole);
  locator->BuildLocator();
  std::vector<vtkIdType> first(static_cast<std::size_t>(whole->GetNumberOfPoints()));
  locator->MergePoints(rounding * whole->GetLength(), first.data());
  std::size_t before = 0;
  for (vtkUnstructuredGrid* piece : pieces)
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(whole->GetPoints()->GetDataType());
    points->SetNumberOfPoints(piece->GetNumberOfPoints());
    for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i)
    {
      points->SetPoint(i, whole->GetPoint(first[before++]));
    }
    piece->SetPoints(points);
  }
}

/**
 * Appends volumes without ghost cells. The volumes are joined before extraction, because separately
 * extracted surfaces would have walls at the seams.
 */
vtkSmartPointer<vtkUnstructuredGrid> appendVolumes(const std::vector<vtkDataSet*>& given)
{
  std::vector<vtkSmartPointer<vtkUnstructuredGrid>> pieces;
  for (vtkDataSet* piece : given)
  {
    vtkNew<vtkAppendFilter> unstructured;
    unstructured->AddInputData(piece);
    unstructured->Update();
    vtkUnstructuredGrid* own = unstructured->GetOutput();
    own->RemoveGhostCells();
    own->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
    own->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
    pieces.emplace_back(own);
  }
  joinRoundedPoints(pieces);
  vtkNew<vtkAppendFilter> all;
  all->MergePointsOn(); // this merges points only if no cell and no point is marked as a ghost
  for (vtkUnstructuredGrid* piece : pieces)
  {
    all->AddInputData(piece);
  }
  all->Update();
  return all->GetOutput();
}

/** Removes points that belong to no triangle. The coordinates of such points may be infinite or
 * NaN. */
vtkSmartPointer<vtkPolyData> withUsedPoints(vtkPolyData* surface)
{
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(surface);
  clean->PointMergingOff();
  clean->ConvertPolysToLinesOff();
  clean->Update();
  return clean->GetOutput();
}

/** Returns the advice in the error message for data that have no triangles. */
std::string triangleAdvice(const std::vector<vtkDataSet*>& pieces)
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
  result.surface = outerFaces(volume, wholeExtent, result.notes, result.fault);
  return result;
}

//------------------------------------------------------------------------------
void cutSurface(
  SurfaceTriangles& made, const std::vector<vtkDataSet*>& pieces, SoundBody::Extent extent)
{
  made.surface = cutPolygons(made.surface, made.notes, made.fault);
  if (!made.surface)
  {
    return;
  }
  if (made.surface->GetNumberOfPolys() > 0)
  {
    MeshDefects found;
    made.fault = orientSurface(made.surface, extent, found);
    if (found.notFinite > 0)
    {
      made.surface = withUsedPoints(made.surface);
      MeshDefects lost;
      std::swap(lost.notFinite, found.notFinite);
      made.loss = describeDefects(lost);
    }
    // These defects are not reported, because they remain unchanged.
    found.degenerate = found.nonManifoldEdges = 0;
    const std::string changes = describeDefects(found);
    if (!changes.empty())
    {
      made.notes.push_back(changes);
    }
  }
  if (made.fault.empty() && made.surface->GetNumberOfPolys() == 0)
  {
    made.fault = triangleAdvice(pieces);
    made.isEmpty = true;
  }
  if (!made.fault.empty())
  {
    made.surface = nullptr;
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
} // namespace palpate
