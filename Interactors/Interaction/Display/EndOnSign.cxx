// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/EndOnSign.h"

#include "Interaction/Display/SceneView.h"

#include "vtkActor2D.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr int SignCorners = 48;
constexpr float SignWidth = 3.0F;   // line width of the sign, pixels
constexpr double SmallestDot = 3.0; // smallest radius of the dot, pixels
constexpr double DotShare = 0.12;   // radius of the dot, as a fraction of the ring's radius
// Largest radius of the ring, as a fraction of the picture's smaller side.
constexpr double LargestRingShare = 0.3;

/// Adds the corners of a circle around the origin with the given radius (pixels). Returns the id of
/// the first corner.
vtkIdType addCircle(vtkPoints* points, double radius)
{
  const vtkIdType first = points->GetNumberOfPoints();
  for (int i = 0; i < SignCorners; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / SignCorners;
    points->InsertNextPoint(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  return first;
}
} // namespace

EndOnSign::EndOnSign(const Color& color)
  : Shape(vtkSmartPointer<vtkPolyData>::New())
  , Actor(vtkSmartPointer<vtkActor2D>::New())
{
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(this->Shape);
  this->Actor->SetMapper(mapper);
  this->Actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  this->Actor->GetProperty()->SetLineWidth(SignWidth);
  this->Actor->GetPositionCoordinate()->SetCoordinateSystemToWorld();
  this->hide();
}

EndOnSign::~EndOnSign() = default;

void EndOnSign::show(
  vtkRenderer* renderer, const Eigen::Vector3d& tail, const Eigen::Vector3d& head)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const Eigen::Vector3d sight = camera->GetParallelProjection()
    ? Eigen::Vector3d(-Eigen::Vector3d(camera->GetDirectionOfProjection()))
    : Eigen::Vector3d(Eigen::Vector3d(camera->GetPosition()) - head);
  const Eigen::Vector3d arrow = head - tail;
  const double along = arrow.dot(sight);
  const double cosine = std::cos(vtkMath::RadiansFromDegrees(LargestAngle));
  const double perMillimetre = pixelsPerMillimetre(renderer, head);
  if (!(std::abs(along) > cosine * arrow.norm() * sight.norm()) || !(perMillimetre > 0.0) ||
    !std::isfinite(perMillimetre))
  {
    this->hide();
    return;
  }
  const int* size = renderer->GetSize();
  const double largest = LargestRingShare * std::min(size[0], size[1]);
  const double radius =
    std::max(std::min(0.5 * arrow.norm() * perMillimetre, largest), SmallestRadius);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> polygons;
  const vtkIdType ring = addCircle(points, radius);
  lines->InsertNextCell(SignCorners + 1);
  for (int i = 0; i <= SignCorners; ++i)
  {
    lines->InsertCellPoint(ring + i % SignCorners);
  }
  if (along > 0.0)
  {
    const vtkIdType dot = addCircle(points, std::max(SmallestDot, DotShare * radius));
    polygons->InsertNextCell(SignCorners);
    for (int i = 0; i < SignCorners; ++i)
    {
      polygons->InsertCellPoint(dot + i);
    }
  }
  else
  {
    const double end = radius * std::sqrt(0.5);
    for (const double rise : { -1.0, 1.0 })
    {
      lines->InsertNextCell(2);
      lines->InsertCellPoint(points->InsertNextPoint(-end, -rise * end, 0.0));
      lines->InsertCellPoint(points->InsertNextPoint(end, rise * end, 0.0));
    }
  }
  this->Shape->SetPoints(points);
  this->Shape->SetLines(lines);
  this->Shape->SetPolys(polygons);
  this->Actor->GetPositionCoordinate()->SetValue(head.x(), head.y(), head.z());
  this->Actor->VisibilityOn();
  this->Radius = radius / perMillimetre;
}

void EndOnSign::hide()
{
  this->Actor->VisibilityOff();
  this->Radius = 0.0;
}
} // namespace palpate
