// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Mesher/OutsideReach.h"

#include "vtkCellArray.h"
#include "vtkFeatureEdges.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace palpate
{
namespace
{
constexpr double OnCut = 1e-9; ///< of a coordinate's size: how nodes on a cut are rounded

/// The closest point of lines or triangles.
class ClosestPlace
{
public:
  explicit ClosestPlace(vtkPolyData* data)
    : IsEmpty(data->GetNumberOfCells() == 0)
  {
    if (!this->IsEmpty)
    {
      this->Locator->SetDataSet(data);
      this->Locator->BuildLocator();
    }
  }

  Eigen::Vector3d operator()(const Eigen::Vector3d& place) const
  {
    Eigen::Vector3d at = place;
    if (!this->IsEmpty)
    {
      Eigen::Vector3d from = place;
      vtkIdType id = -1;
      int part = 0;
      double square = 0.0;
      this->Locator->FindClosestPoint(from.data(), at.data(), this->Cell, id, part, square);
    }
    return at;
  }

private:
  bool IsEmpty;
  vtkNew<vtkStaticCellLocator> Locator;
  vtkNew<vtkGenericCell> Cell;
};

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
  const auto onSurface = std::make_shared<ClosestPlace>(surface);
  const auto onEdge = std::make_shared<ClosestPlace>(edges->GetOutput());
  const auto onRim = std::make_shared<ClosestPlace>(linesOf(wanted));
  return [=](const Eigen::Vector3d& middle, bool isSharp)
  {
    const bool isOnCut = std::any_of(cuts.begin(), cuts.end(),
      [&](const CutPlane& cut) {
        return std::abs(middle[cut.axis] - cut.at) <= OnCut * (std::abs(cut.at) + middle.norm());
      });
    return !isSharp ? (*onSurface)(middle) : isOnCut ? (*onRim)(middle) : (*onEdge)(middle);
  };
}
} // namespace palpate
