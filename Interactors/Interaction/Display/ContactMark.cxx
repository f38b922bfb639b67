// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/ContactMark.h"

#include "Interaction/Display/DashedLine.h"
#include "Interaction/Display/DisplayColors.h"
#include "Interaction/Display/RigidFrame.h"

#include "vtkActor.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkTubeFilter.h"

#include <cmath>

namespace palpate
{
namespace
{
constexpr int Corners = 96;
constexpr int Dashes = 16;
// The line is thinner on small circles, so that they stay circles, but can be seen.
constexpr double LineRadius = 0.08; // mm
constexpr double LineShare = 0.05;  // of the circle's radius
} // namespace

ContactCircle::ContactCircle()
  : Tube(vtkSmartPointer<vtkTubeFilter>::New())
  , Actor(vtkSmartPointer<vtkActor>::New())
{
  this->Tube->SetNumberOfSides(8);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(this->Tube->GetOutputPort());
  mapper->ScalarVisibilityOff();
  this->Actor->SetMapper(mapper);
  this->Actor->GetProperty()->SetColor(CircleColor[0], CircleColor[1], CircleColor[2]);
  this->Actor->GetProperty()->LightingOff();
  this->hide();
}

ContactCircle::~ContactCircle() = default;

void ContactCircle::show(
  const Eigen::Vector3d& center, const Eigen::Vector3d& normal, double radius, bool dashed)
{
  if (!std::isfinite(radius) || !(radius > 0.0) || !(normal.norm() > 0.0))
  {
    this->hide();
    return;
  }
  const double dash = vtkMath::Pi() * radius / Dashes;
  DashedLine line(dash, dash);
  const auto corner = [radius](int i) -> Eigen::Vector3d
  {
    const double angle = 2.0 * vtkMath::Pi() * i / Corners;
    return { radius * std::cos(angle), radius * std::sin(angle), 0.0 };
  };
  line.moveTo(corner(0));
  for (int i = 1; i <= Corners; ++i)
  {
    line.lineTo(corner(i), 0.0, dashed);
  }
  this->Tube->SetInputData(line.take("Circle"));
  this->Tube->SetRadius(LineRadius + LineShare * radius);
  this->Actor->SetUserMatrix(frameAlong(center.data(), normal.data(), 2));
  this->Actor->VisibilityOn();
}

void ContactCircle::hide()
{
  this->Actor->VisibilityOff();
}

vtkSmartPointer<vtkActor> makePlaceMarker()
{
  constexpr double radius = 2.0; // mm
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(radius);
  ball->SetThetaResolution(24);
  ball->SetPhiResolution(24);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  auto marker = vtkSmartPointer<vtkActor>::New();
  marker->SetMapper(mapper);
  marker->GetProperty()->SetColor(ToolColor[0], ToolColor[1], ToolColor[2]);
  marker->VisibilityOff();
  return marker;
}

void placeMarker(const ShownContact& contact, vtkActor* marker)
{
  const Eigen::Vector3d& place =
    contact.touches() ? contact.tick.contact.contactPoint : contact.tick.tip;
  marker->SetPosition(place.x(), place.y(), place.z());
}
} // namespace palpate
