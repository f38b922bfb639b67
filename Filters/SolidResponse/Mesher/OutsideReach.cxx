// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Mesher/OutsideReach.h"

#include "SolidResponse/Bodies/ClosestPlace.h"

#include "vtkCellArray.h"
#include "vtkFeatureEdges.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
/// Tolerance for the rounding of nodes on a cut, relative to the coordinates.
constexpr double OnCut = 1e-9;

/// Returns a locator for lines or triangles. Returns null if `data` has no cells.
vtkSmartPointer<vtkStaticCellLocator> locatorOf(vtkPolyData* data)
{
  if (data->GetNumberOfCells() == 0)
  {
    return nullptr;
  }
  auto made = vtkSmartPointer<vtkStaticCellLocator>::New();
  made->SetDataSet(data);
  made->BuildLocator();
  return made;
}

vtkSmartPointer<vtkPolyData> linesOf(const MeshedSurface& wanted)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const std::array<std::int32_t, 2>& rim : wanted.rims)
  {
    lines->InsertNextCell(2);
    for (const std::int32_t end : rim)
    {
      lines->InsertCellPoint(points->InsertNextPoint(wanted.points.col(end).data()));
    }
  }
  auto made = vtkSmartPointer<vtkPolyData>::New();
  made->SetPoints(points);
  made->SetLines(lines);
  return made;
}
} // namespace

EdgeReach outsideReach(
  vtkPolyData* surface, const MeshedSurface& wanted, const std::vector<CutPlane>& cuts)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->SetFeatureAngle(wanted.sharpAngle);
  edges->BoundaryEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->ColoringOff();
  edges->Update();
  const auto onSurface = locatorOf(surface);
  const auto onEdge = locatorOf(edges->GetOutput());
  const auto onRim = locatorOf(linesOf(wanted));
  return [=](const Eigen::Vector3d& middle, bool isSharp)
  {
    const bool isOnCut = std::any_of(cuts.begin(), cuts.end(),
      [&](const CutPlane& cut) {
        return std::abs(middle[cut.axis] - cut.at) <= OnCut * (std::abs(cut.at) + middle.norm());
      });
    vtkStaticCellLocator* lies = !isSharp ? onSurface : isOnCut ? onRim : onEdge;
    return lies ? closestPlace(lies, middle).at : middle;
  };
}
} // namespace palpate
