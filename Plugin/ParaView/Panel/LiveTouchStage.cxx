// SPDX-License-Identifier: BSD-3-Clause
#include "LiveTouchStage.h"

#include "LiveTouchSession.h"

#include "pqRenderView.h"
#include "vtkCallbackCommand.h"
#include "vtkPVRenderView.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSMRenderViewProxy.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr double ToolShare = 0.15; // length of the tool as a fraction of the body's size
// Length of the arrow of the largest force, as a fraction of the body's size.
constexpr double ArrowShare = 0.5;
constexpr double SmallestChange = 1e-3; // smallest visible change, mm and N

vtkRenderer* rendererOf(pqRenderView* view)
{
  auto* drawn = vtkPVRenderView::SafeDownCast(view->getClientSideView());
  return drawn ? drawn->GetNonCompositedRenderer() : nullptr;
}
} // namespace

LiveTouchStage::LiveTouchStage()
{
  this->Cross->AllOff();
  this->Cross->GetProperty()->SetColor(0.95, 0.75, 0.1);
  this->Cross->GetProperty()->SetLineWidth(3.0);
  this->Widget->SetRepresentation(this->Cross);
  vtkNew<vtkCallbackCommand> released;
  released->SetClientData(this);
  released->SetCallback(&LiveTouchStage::onRelease);
  this->Widget->AddObserver(vtkCommand::EndInteractionEvent, released);
}

void LiveTouchStage::onRelease(vtkObject*, unsigned long, void* stage, void*)
{
  static_cast<LiveTouchStage*>(stage)->Released = true;
}

void LiveTouchStage::enter(pqRenderView* view)
{
  this->leave();
  this->View = view;
}

void LiveTouchStage::leave()
{
  if (!this->View)
  {
    return;
  }
  this->Widget->SetEnabled(0);
  this->Widget->SetDefaultRenderer(nullptr);
  this->Widget->SetCurrentRenderer(nullptr);
  this->Widget->SetInteractor(nullptr);
  if (vtkRenderer* renderer = rendererOf(this->View))
  {
    renderer->RemoveViewProp(this->Tool);
    renderer->RemoveViewProp(this->Cross);
  }
  this->Cross->SetRenderer(nullptr);
  this->View = nullptr;
}

void LiveTouchStage::prepare(LiveTouchSession& touch)
{
  vtkRenderer* renderer = this->View ? rendererOf(this->View) : nullptr;
  if (!renderer || !touch.tool())
  {
    return;
  }
  const double size = touch.body()->GetLength();
  this->Tool->SetTool(touch.tool());
  this->Tool->SetToolLength(ToolShare * size);
  this->Tool->SetForceScale(touch.peakForce() > 0.0 ? ArrowShare * size / touch.peakForce() : 1.0);
  const LiveTouchPlace& place = touch.place();
  const double none[3] = { 0.0, 0.0, 0.0 };
  this->Tool->SetContact(place.surface.data(), place.normal.data(), place.surface.data(), none);
  renderer->AddViewProp(this->Tool); // a repeated call has no effect
  this->ShowsNothing = true;
}

bool LiveTouchStage::show(LiveTouchSession& touch)
{
  vtkHapticSession* session = touch.session();
  if (!session || !this->View || session->GetNumberOfTicks() == 0)
  {
    return false;
  }
  Eigen::Vector3d tip;
  Eigen::Vector3d force;
  Eigen::Vector3d applied;
  session->GetTip(tip.data());
  session->GetIdealForce(force.data());
  session->GetForce(applied.data());
  const double moved = std::max(
    { (tip - this->Tip).norm(), (force - this->Force).norm(), (applied - this->Applied).norm() });
  if (!this->ShowsNothing && moved < SmallestChange)
  {
    return false;
  }
  Eigen::Vector3d normal;
  Eigen::Vector3d contact;
  Eigen::Vector3d friction;
  session->GetNormal(normal.data());
  session->GetContactPoint(contact.data());
  session->GetFrictionForce(friction.data());
  this->Tool->SetContact(
    tip.data(), normal.data(), contact.data(), force.data(), friction.data(), applied.data());
  this->Tip = tip;
  this->Force = force;
  this->Applied = applied;
  this->ShowsNothing = false;
  return true;
}

void LiveTouchStage::showHandle(const Eigen::Vector3d& position)
{
  vtkRenderer* renderer = this->View ? rendererOf(this->View) : nullptr;
  if (!renderer)
  {
    return;
  }
  double at[3] = { position.x(), position.y(), position.z() };
  this->Widget->SetDefaultRenderer(renderer);
  this->Widget->SetCurrentRenderer(renderer);
  this->Widget->SetInteractor(this->View->getRenderViewProxy()->GetInteractor());
  this->Cross->SetRenderer(renderer);
  this->Cross->SetHandleSize(30.0); // size of the handle, pixels
  this->Cross->SetWorldPosition(at);
  this->Widget->SetEnabled(1);
  this->Released = false;
}

bool LiveTouchStage::hasHandle() const
{
  return this->Widget->GetEnabled() != 0;
}

Eigen::Vector3d LiveTouchStage::handle() const
{
  Eigen::Vector3d position;
  this->Cross->GetWorldPosition(position.data());
  return position;
}

void LiveTouchStage::settleHandle(const LiveTouchPlace& place)
{
  if (this->Released)
  {
    double at[3] = { place.surface.x(), place.surface.y(), place.surface.z() };
    this->Cross->SetWorldPosition(at);
    this->Released = false;
    this->ShowsNothing = true;
  }
}
} // namespace palpate
