// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/ForceScale.h"

#include "Interaction/Display/DisplayColors.h"
#include "Response/RoundNumber.h"

#include "vtkActor2D.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace palpate
{
namespace
{
constexpr double Margin = 24.0;     // pixels, to the right edge
constexpr double Height = 26.0;     // of the arrow's axis above the lower edge
constexpr double HalfShaft = 2.0;   // pixels
constexpr double HalfHead = 6.5;    // pixels
constexpr double HeadLength = 14.0; // pixels, at most half of the arrow
constexpr double LabelWidth = 60.0; // pixels, more than that of any
constexpr double LargestShare = 1.0 / 3.0;

/// Pixels per mm, across the line of sight, at a point.
double pixelsPerMillimetre(vtkRenderer* renderer, const Eigen::Vector3d& point)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const Eigen::Vector3d ahead(camera->GetDirectionOfProjection());
  const Eigen::Vector3d right = ahead.cross(Eigen::Vector3d(camera->GetViewUp())).normalized();
  const auto inPicture = [&](Eigen::Vector3d world) -> Eigen::Vector2d
  {
    renderer->WorldToView(world.x(), world.y(), world.z());
    return { 0.5 * renderer->GetSize()[0] * world.x(), 0.5 * renderer->GetSize()[1] * world.y() };
  };
  return (inPicture(point + right) - inPicture(point)).norm();
}
} // namespace

ForceScale::ForceScale()
  : Shape(vtkSmartPointer<vtkPolyData>::New())
  , Arrow(vtkSmartPointer<vtkActor2D>::New())
  , Label(vtkSmartPointer<vtkTextActor>::New())
{
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(this->Shape);
  this->Arrow->SetMapper(mapper);
  this->Arrow->GetProperty()->SetColor(ForceColor[0], ForceColor[1], ForceColor[2]);
  vtkTextProperty* text = this->Label->GetTextProperty();
  text->SetColor(TextColor.data());
  text->SetFontSize(15);
  text->SetJustificationToRight();
}

ForceScale::~ForceScale() = default;

void ForceScale::choose(double largestForce, double scale)
{
  this->Force = roundDown(0.5 * largestForce);
  this->Scale = scale;
}

void ForceScale::setVisibility(bool visible)
{
  this->Arrow->SetVisibility(visible);
  this->Label->SetVisibility(visible);
}

void ForceScale::place(vtkRenderer* renderer, const Eigen::Vector3d& contact)
{
  const double width = renderer->GetSize()[0];
  const double perNewton = this->Scale * pixelsPerMillimetre(renderer, contact);
  if (!std::isfinite(perNewton) || !(perNewton > 0.0))
  {
    return;
  }
  const double most = LargestShare * width / perNewton;
  const double force = this->Force <= most ? this->Force : roundDown(most);
  const double length = force * perNewton;
  this->Width = std::max(length, LabelWidth) + Margin;
  const double head = width - Margin;
  const double tail = head - length;
  const double neck = head - std::min(HeadLength, 0.5 * length);
  vtkNew<vtkPoints> corners;
  for (const auto& [x, y] : { std::array{ tail, -HalfShaft }, std::array{ neck, -HalfShaft },
         std::array{ neck, -HalfHead }, std::array{ head, 0.0 }, std::array{ neck, HalfHead },
         std::array{ neck, HalfShaft }, std::array{ tail, HalfShaft } })
  {
    corners->InsertNextPoint(x, Height + y, 0.0);
  }
  vtkNew<vtkCellArray> parts; // shaft and head: together they are not convex
  parts->InsertNextCell({ 0, 1, 5, 6 });
  parts->InsertNextCell({ 2, 3, 4 });
  this->Shape->SetPoints(corners);
  this->Shape->SetPolys(parts);
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g N", force);
  this->Label->SetInput(text.data());
  this->Label->SetPosition(head, Height + HalfHead + 4.0);
}
} // namespace palpate
