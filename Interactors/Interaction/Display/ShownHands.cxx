// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/ShownHands.h"

#include "Haptics/Servo/HandsStep.h"
#include "vtkContactTool.h"
#include "vtkHapticToolRepresentation.h"

#include "vtkBoundingBox.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace palpate
{
ShownHands::ShownHands()
  : FreeDirections(HandsStep::Most, Eigen::Vector3d::Zero())
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
} // namespace palpate
