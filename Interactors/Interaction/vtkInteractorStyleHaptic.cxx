// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInteractorStyleHaptic.h"

#include "Interaction/Panel/KeyHelp.h"
#include "Interaction/Panel/SteeredHand.h"
#include "Interaction/Panel/SurfacePicker.h"
#include "Haptics/Servo/ServoStep.h"
#include "vtkContactScene.h"
#include "vtkHapticDevice.h"
#include "vtkHapticSession.h"
#include "vtkSessionFiles.h"

#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace
{
constexpr double DepthPerNotch = 0.1; // depth per notch of the wheel, mm
} // namespace

vtkStandardNewMacro(vtkInteractorStyleHaptic);

vtkInteractorStyleHaptic::vtkInteractorStyleHaptic()
  : Picker(std::make_unique<palpate::SurfacePicker>())
  , Help(std::make_unique<palpate::KeyHelp>())
  , Hands(1)
{
  this->Help->setText(OwnKeys());
}

vtkInteractorStyleHaptic::~vtkInteractorStyleHaptic() = default;

void vtkInteractorStyleHaptic::SetSession(vtkHapticSession* session)
{
  this->Session = session;
  this->Modified();
}

void vtkInteractorStyleHaptic::SetScene(vtkContactScene* scene)
{
  this->Scene = scene;
  this->Modified();
}

void vtkInteractorStyleHaptic::SetFiles(vtkSessionFiles* files)
{
  this->Files = files;
  this->Modified();
}

vtkHapticSession* vtkInteractorStyleHaptic::GetSession()
{
  return this->Session;
}

vtkContactScene* vtkInteractorStyleHaptic::GetScene()
{
  return this->Scene;
}

vtkSessionFiles* vtkInteractorStyleHaptic::GetFiles()
{
  return this->Files;
}

void vtkInteractorStyleHaptic::SetPressDepth(double depth)
{
  this->PressDepth = std::clamp(depth, 0.0, this->MaximumDepth);
  this->Modified();
}

void vtkInteractorStyleHaptic::SetWheelDepth(double depth)
{
  constexpr double rounding = 1e-9; // tolerance for the rounding error of a sum of notches
  this->Steered().wheelDepth = depth < rounding ? 0.0 : std::min(depth, this->MaximumDepth);
  this->Modified();
}

double vtkInteractorStyleHaptic::GetWheelDepth() const
{
  return this->Steered().wheelDepth;
}

void vtkInteractorStyleHaptic::SetHand(int hand)
{
  const int last = static_cast<int>(palpate::ServoStep::Most) - 1;
  this->Hand = std::clamp(hand, 0, last);
  this->Hands.resize(std::max(this->Hands.size(), static_cast<std::size_t>(this->Hand) + 1));
  this->Modified();
}

palpate::SteeredHand& vtkInteractorStyleHaptic::Steered()
{
  return this->Hands[static_cast<std::size_t>(this->Hand)];
}

const palpate::SteeredHand& vtkInteractorStyleHaptic::Steered() const
{
  return this->Hands[static_cast<std::size_t>(this->Hand)];
}

vtkHapticDevice* vtkInteractorStyleHaptic::SteeredDevice()
{
  return this->Session->GetDevice(std::min(this->Hand, this->Session->GetNumberOfDevices() - 1));
}

vtkRenderer* vtkInteractorStyleHaptic::FindSceneRenderer()
{
  vtkRenderer* renderer = this->Scene ? this->Scene->GetRenderer() : nullptr;
  const int* position = this->Interactor->GetEventPosition();
  return renderer && renderer->IsInViewport(position[0], position[1]) ? renderer : nullptr;
}

bool vtkInteractorStyleHaptic::IsOutsideScene()
{
  const int* position = this->Interactor->GetEventPosition();
  vtkRenderer* poked = this->Interactor->FindPokedRenderer(position[0], position[1]);
  return !poked || !poked->GetInteractive() || !poked->IsInViewport(position[0], position[1]);
}

bool vtkInteractorStyleHaptic::PickSurface(double point[3], double normal[3])
{
  vtkRenderer* renderer = this->FindSceneRenderer();
  if (!renderer || !this->Session)
  {
    return false;
  }
  this->Picker->setBody(this->Session->GetBody(), this->Session->GetResponseName());
  return this->Picker->pick(renderer, this->Interactor->GetEventPosition(), point, normal);
}

bool vtkInteractorStyleHaptic::SteerOverSurface()
{
  double point[3];
  double normal[3];
  const palpate::SteeredHand& hand = this->Steered();
  const bool isOver = this->PickSurface(point, normal);
  this->OffBody = !isOver && hand.touches && hand.height < 0.0;
  if (!isOver)
  {
    return false;
  }
  const bool byButton = this->Pressing && !this->KeepsWheelDepth;
  const double depth = byButton ? this->PressDepth : this->GetWheelDepth();
  this->TouchAt(point, normal, depth > 0.0 ? -depth : this->HoverHeight);
  return true;
}

bool vtkInteractorStyleHaptic::IsPointerOffBody()
{
  return this->OffBody && this->Interactor && this->FindSceneRenderer();
}

/// Steers the tip to a height (mm) above a point of the surface. At a negative height the tool
/// presses.
void vtkInteractorStyleHaptic::TouchAt(const double point[3], const double normal[3], double height)
{
  palpate::SteeredHand& hand = this->Steered();
  hand.touches = true;
  hand.height = height;
  for (int k = 0; k < 3; ++k)
  {
    hand.point[k] = point[k];
    hand.normal[k] = normal[k];
    hand.tip[k] = point[k] + height * normal[k];
  }
  this->FaceAlong(normal);
  if (this->Session)
  {
    this->SteerAlike(this->SteeredDevice());
  }
  this->InvokeEvent(SteeredEvent, hand.tip);
}

void vtkInteractorStyleHaptic::SteerAlike(vtkHapticDevice* device) const
{
  const palpate::SteeredHand& hand = this->Steered();
  if (hand.touches)
  {
    device->TouchAt(hand.point, hand.normal, hand.height);
  }
  else
  {
    device->SteerTo(hand.tip);
  }
}

/// Steers the tip to the point under the pointer whose distance from the viewer is that of the
/// present tip plus `away` (mm).
bool vtkInteractorStyleHaptic::SteerInView(double away)
{
  vtkRenderer* renderer = this->FindSceneRenderer();
  if (!renderer || !this->Session)
  {
    return false;
  }
  double tip[3];
  double towards[3];
  palpate::pointInView(
    renderer, this->Interactor->GetEventPosition(), this->Steered().tip, away, tip, towards);
  this->FaceAlong(towards);
  this->SteerTo(tip);
  return true;
}

bool vtkInteractorStyleHaptic::Steer()
{
  this->OffBody = false;
  return this->Steering == ViewPlane ? this->SteerInView(0.0) : this->SteerOverSurface();
}

void vtkInteractorStyleHaptic::HoverAt(const double point[3], const double normal[3])
{
  this->TouchAt(point, normal, this->HoverHeight);
}

/// Sets the direction of the tool while it has no contact, and its tilt relative to that direction.
void vtkInteractorStyleHaptic::FaceAlong(const double direction[3])
{
  const palpate::SteeredTilt& tilt = this->Steered().tilt;
  if (this->Session && tilt.isSet())
  {
    this->SteeredDevice()->TurnTo(
      tilt.axis(direction, this->Scene ? this->Scene->GetRenderer() : nullptr).data());
  }
  if (this->Scene)
  {
    this->Scene->SetFreeDirection(this->Hand, direction);
  }
}

void vtkInteractorStyleHaptic::SetTilt(double right, double away)
{
  this->Steered().tilt.set(right, away);
  this->Modified();
}

void vtkInteractorStyleHaptic::GetTilt(double tilt[2]) const
{
  tilt[0] = this->Steered().tilt.right();
  tilt[1] = this->Steered().tilt.away();
}

void vtkInteractorStyleHaptic::Lean(double right, double away)
{
  this->Steered().tilt.lean(right, away);
  this->Steer();
}

void vtkInteractorStyleHaptic::SteerTo(const double tip[3])
{
  palpate::SteeredHand& hand = this->Steered();
  hand.touches = false;
  std::copy_n(tip, 3, hand.tip);
  if (this->Session)
  {
    this->SteerAlike(this->SteeredDevice());
  }
  this->InvokeEvent(SteeredEvent, hand.tip);
}

void vtkInteractorStyleHaptic::OnMouseMove()
{
  if (this->State == VTKIS_NONE)
  {
    this->Steer();
  }
  this->Superclass::OnMouseMove();
}

void vtkInteractorStyleHaptic::OnLeftButtonDown()
{
  this->Pressing = this->Steering == Surface;
  this->KeepsWheelDepth = this->GetWheelDepth() > 0.0;
  if (this->Pressing && this->SteerOverSurface())
  {
    return;
  }
  this->Pressing = false;
  if (!this->IsOutsideScene())
  {
    this->Superclass::OnLeftButtonDown();
  }
}

void vtkInteractorStyleHaptic::OnLeftButtonUp()
{
  if (this->Pressing)
  {
    this->Pressing = false;
    this->Steer();
    return;
  }
  this->Superclass::OnLeftButtonUp();
}

void vtkInteractorStyleHaptic::OnMiddleButtonDown()
{
  if (!this->IsOutsideScene())
  {
    this->Superclass::OnMiddleButtonDown();
  }
}

void vtkInteractorStyleHaptic::OnRightButtonDown()
{
  if (!this->IsOutsideScene())
  {
    this->Superclass::OnRightButtonDown();
  }
}

/// Handles the wheel. Returns false if the wheel zooms.
bool vtkInteractorStyleHaptic::TurnWheel(double notches)
{
  if (this->IsOutsideScene())
  {
    return true;
  }
  if (this->Interactor->GetControlKey())
  {
    return false;
  }
  if (this->Interactor->GetShiftKey())
  {
    this->Lean(notches * palpate::SteeredTilt::PerNotch, 0.0);
    return true;
  }
  double point[3];
  double normal[3];
  if (this->Steering == ViewPlane)
  {
    if (!this->SteerInView(notches * DepthPerNotch))
    {
      return false;
    }
    this->WheelPressed = this->WheelPressed || notches > 0.0;
    return true;
  }
  if (!this->Pressing && !this->PickSurface(point, normal))
  {
    return false;
  }
  this->WheelPressed = this->WheelPressed || notches > 0.0;
  const bool byButton = this->Pressing && !this->KeepsWheelDepth;
  const double wanted =
    (byButton ? this->PressDepth : this->GetWheelDepth()) + notches * DepthPerNotch;
  constexpr double rounding = 1e-9; // tolerance for the rounding error of a sum of notches
  this->AtGreatestDepth = notches > 0.0 && wanted > this->MaximumDepth + rounding;
  if (byButton)
  {
    this->SetPressDepth(wanted);
  }
  else
  {
    this->SetWheelDepth(wanted);
  }
  this->Steer();
  return true;
}

void vtkInteractorStyleHaptic::OnMouseWheelForward()
{
  if (!this->TurnWheel(1.0))
  {
    this->Superclass::OnMouseWheelForward();
  }
}

void vtkInteractorStyleHaptic::OnMouseWheelBackward()
{
  if (!this->TurnWheel(-1.0))
  {
    this->Superclass::OnMouseWheelBackward();
  }
}

void vtkInteractorStyleHaptic::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Steering: " << this->Steering << "\n";
  os << indent << "PressDepth: " << this->PressDepth << " mm\n";
  os << indent << "WheelDepth: " << this->GetWheelDepth() << " mm\n";
  os << indent << "MaximumDepth: " << this->MaximumDepth << " mm\n";
  os << indent << "HoverHeight: " << this->HoverHeight << " mm\n";
  const palpate::SteeredTilt& tilt = this->Steered().tilt;
  os << indent << "Tilt: " << tilt.right() << ", " << tilt.away() << " degrees\n";
  os << indent << "Hand: " << this->Hand << "\n";
  os << indent << "Pressing: " << this->Pressing << "\n";
}
