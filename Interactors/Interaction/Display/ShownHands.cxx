// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/ShownHands.h"

#include "Haptics/Servo/ServoStep.h"
#include "Interaction/Display/DashedLine.h"
#include "Interaction/Display/DisplayColors.h"
#include "Interaction/Display/RigidFrame.h"
#include "vtkContactTool.h"
#include "vtkHapticToolRepresentation.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkTubeFilter.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr int Corners = 96;
constexpr int Dashes = 16;
// The radius of the line is LineRadius plus LineShare times the radius of the circle. Therefore the
// line is thin on a small circle but remains visible.
constexpr double LineRadius = 0.08; // mm
constexpr double LineShare = 0.05;  // fraction of the circle's radius
} // namespace

ShownHands::ShownHands()
  : FreeDirections(ServoStep::Most, Eigen::Vector3d::Zero())
{
  this->Hands.push_back(this->makeHand());
}

ShownHands::~ShownHands() = default;

ShownHands::Hand ShownHands::makeHand() const
{
  return { vtkSmartPointer<vtkHapticToolRepresentation>::New(), std::make_unique<ContactCircle>() };
}

void ShownHands::addToRenderer(const Hand& hand)
{
  if (this->Renderer)
  {
    this->Renderer->AddViewProp(hand.circle->actor());
    this->Renderer->AddViewProp(hand.tool);
  }
}

void ShownHands::setRenderer(vtkRenderer* renderer)
{
  this->Renderer = renderer;
  for (const Hand& hand : this->Hands)
  {
    this->addToRenderer(hand);
  }
}

void ShownHands::setTool(vtkContactTool* tool)
{
  for (const Hand& hand : this->Hands)
  {
    hand.tool->SetTool(tool);
  }
}

void ShownHands::setVisibility(bool visible)
{
  for (const Hand& hand : this->Hands)
  {
    hand.tool->SetVisibility(visible);
  }
}

void ShownHands::leaveFree(std::vector<LabelObstacle> obstacles)
{
  this->tool()->LeaveFree(std::move(obstacles)); // the labels of the other hands avoid the same
                                                 // obstacles as those of the first hand
}

void ShownHands::setSteadyLabels(bool steady)
{
  for (const Hand& hand : this->Hands)
  {
    hand.tool->SetSteadyLabels(steady);
  }
}

void ShownHands::resize(std::size_t count)
{
  while (this->Hands.size() > std::max<std::size_t>(count, 1))
  {
    if (this->Renderer)
    {
      this->Renderer->RemoveViewProp(this->Hands.back().tool);
      this->Renderer->RemoveViewProp(this->Hands.back().circle->actor());
    }
    this->Hands.pop_back();
  }
  while (this->Hands.size() < count)
  {
    Hand added = this->makeHand();
    added.tool->SetTool(this->tool()->GetTool());
    added.tool->SetVisibility(this->tool()->GetVisibility());
    added.tool->SetSteadyLabels(this->tool()->GetSteadyLabels());
    added.tool->SetLabelsAfter(this->Hands.back().tool);
    this->addToRenderer(added);
    this->Hands.push_back(std::move(added));
  }
}

void ShownHands::setFreeDirection(std::size_t hand, const Eigen::Vector3d& direction)
{
  if (hand < this->FreeDirections.size())
  {
    this->FreeDirections[hand] = direction;
  }
}

Eigen::Vector3d ShownHands::freeDirection(std::size_t hand) const
{
  return hand < this->FreeDirections.size() ? this->FreeDirections[hand] : Eigen::Vector3d::Zero();
}

void ShownHands::show(std::size_t hand, const ShownContact& contact, double radius, double depth)
{
  const Hand& shown = this->Hands[hand];
  vtkHapticToolRepresentation* tool = shown.tool;
  if (hand > 0)
  {
    tool->SetForceScale(this->tool()->GetForceScale());
    tool->SetToolLength(this->tool()->GetToolLength());
    tool->SetComponentsVisibility(this->tool()->GetComponentsVisibility());
    tool->SetAppliedForceVisibility(this->tool()->GetAppliedForceVisibility());
  }
  const Tick& tick = contact.tick;
  const Contact& felt = tick.contact;
  const bool hasApplied = contact.hasApplied && tool->GetAppliedForceVisibility();
  tool->SetBeyondValidity(!contact.isValid());
  tool->SetContactRadius(contact.touches() && std::isfinite(radius) ? radius : 0.0);
  tool->SetTilt(tick.axis.data(), tick.idealTorque.data());
  tool->SetContact(tick.tip.data(), felt.normal.data(), felt.contactPoint.data(),
    tick.idealForce.data(), felt.friction.data(),
    (hasApplied ? tick.appliedForce : tick.idealForce).data());
  shown.circle->show(felt.contactPoint - depth * felt.normal, felt.normal,
    contact.touches() ? radius : 0.0, !contact.isValid());
}

void ShownHands::hideCircles()
{
  for (const Hand& hand : this->Hands)
  {
    hand.circle->hide();
  }
}

void ShownHands::addBounds(vtkBoundingBox& box) const
{
  for (const Hand& hand : this->Hands)
  {
    if (const double* bounds = hand.tool->GetBounds())
    {
      box.AddBounds(bounds);
    }
  }
}

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
