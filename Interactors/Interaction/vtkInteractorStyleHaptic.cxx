// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInteractorStyleHaptic.h"

#include "vtkContactScene.h"
#include "vtkHapticSession.h"

#include "vtkDataArray.h"
#include "vtkGenericCell.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace
{
constexpr double DepthPerNotch = 0.1;     // mm
constexpr unsigned long TimerPeriod = 33; // ms

/// World point under a display position, at a depth of the view volume from 0 (near) to 1 (far).
void worldAt(vtkRenderer* renderer, const int* position, double depth, double world[3])
{
  renderer->SetDisplayPoint(position[0], position[1], depth);
  renderer->DisplayToWorld();
  double point[4];
  renderer->GetWorldPoint(point);
  for (int k = 0; k < 3; ++k)
  {
    world[k] = point[k] / point[3];
  }
}
} // namespace

vtkStandardNewMacro(vtkInteractorStyleHaptic);

vtkInteractorStyleHaptic::vtkInteractorStyleHaptic() = default;
vtkInteractorStyleHaptic::~vtkInteractorStyleHaptic() = default;

void vtkInteractorStyleHaptic::SetSession(vtkHapticSession* session)
{
  this->Session = session;
  this->Locator = nullptr;
  this->Body = nullptr;
  if (session && session->GetBody())
  {
    this->Body =
      vtkSmartPointer<vtkPolyData>::New(); // a locator builds links; not in the session's
    this->Body->ShallowCopy(session->GetBody());
  }
}

void vtkInteractorStyleHaptic::SetScene(vtkContactScene* scene)
{
  this->Scene = scene;
}

void vtkInteractorStyleHaptic::SetPressDepth(double depth)
{
  this->PressDepth = std::clamp(depth, 0.0, this->MaximumDepth);
  this->Modified();
}

void vtkInteractorStyleHaptic::StartUpdates()
{
  if (this->Interactor)
  {
    this->UseTimers = 1;
    this->Interactor->CreateRepeatingTimer(TimerPeriod);
  }
}

bool vtkInteractorStyleHaptic::PickSurface(double point[3], double normal[3])
{
  const int* position = this->Interactor->GetEventPosition();
  this->FindPokedRenderer(position[0], position[1]);
  if (!this->CurrentRenderer || !this->Body)
  {
    return false;
  }
  if (!this->Locator)
  {
    this->Locator = vtkSmartPointer<vtkStaticCellLocator>::New();
    this->Locator->SetDataSet(this->Body);
    this->Locator->BuildLocator();
  }
  double nearPoint[3];
  double farPoint[3];
  worldAt(this->CurrentRenderer, position, 0.0, nearPoint);
  worldAt(this->CurrentRenderer, position, 1.0, farPoint);
  double t = 0.0;
  double parametric[3];
  int subId = 0;
  vtkIdType cellId = -1;
  vtkNew<vtkGenericCell> cell;
  if (!this->Locator->IntersectWithLine(
        nearPoint, farPoint, 0.0, t, point, parametric, subId, cellId, cell))
  {
    return false;
  }
  vtkDataArray* normals =
    this->Body->GetPointData()->GetArray((this->Session->GetResponseName() + "Normal").c_str());
  double weights[3] = { 1.0 - parametric[0] - parametric[1], parametric[0], parametric[1] };
  std::fill_n(normal, 3, 0.0);
  for (vtkIdType k = 0; normals && k < 3; ++k)
  {
    const double* corner = normals->GetTuple3(cell->GetPointId(k));
    for (int i = 0; i < 3; ++i)
    {
      normal[i] += weights[k] * corner[i];
    }
  }
  return vtkMath::Normalize(normal) > 0.0;
}

bool vtkInteractorStyleHaptic::Steer()
{
  double point[3];
  double normal[3];
  if (!this->Session || !this->PickSurface(point, normal))
  {
    return false;
  }
  this->SteerTo(point, normal, this->Pressing ? -this->PressDepth : this->HoverHeight);
  return true;
}

void vtkInteractorStyleHaptic::HoverAt(const double point[3], const double normal[3])
{
  this->SteerTo(point, normal, this->HoverHeight);
}

void vtkInteractorStyleHaptic::SteerTo(const double point[3], const double normal[3], double height)
{
  double tip[3];
  for (int k = 0; k < 3; ++k)
  {
    tip[k] = point[k] + height * normal[k];
  }
  std::copy_n(normal, 3, this->HoverNormal);
  if (this->Session)
  {
    this->Session->SteerTo(tip);
  }
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
  this->Pressing = true;
  if (!this->Steer())
  {
    this->Pressing = false;
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

void vtkInteractorStyleHaptic::OnMouseWheelForward()
{
  if (!this->Pressing)
  {
    this->Superclass::OnMouseWheelForward();
    return;
  }
  this->SetPressDepth(this->PressDepth + DepthPerNotch);
  this->Steer();
}

void vtkInteractorStyleHaptic::OnMouseWheelBackward()
{
  if (!this->Pressing)
  {
    this->Superclass::OnMouseWheelBackward();
    return;
  }
  this->SetPressDepth(this->PressDepth - DepthPerNotch);
  this->Steer();
}

void vtkInteractorStyleHaptic::OnChar()
{
  const char key = this->Interactor->GetKeyCode();
  if (key >= '1' && key <= '9')
  {
    int tool = key - '1';
    this->InvokeEvent(ToolChosenEvent, &tool);
    return;
  }
  if (key == ' ')
  {
    this->InvokeEvent(SwitchEvent);
    return;
  }
  this->Superclass::OnChar();
}

void vtkInteractorStyleHaptic::TellSafety()
{
  double applied[3];
  this->Session->GetForce(applied);
  std::ostringstream text;
  text << "Applied " << std::fixed << std::setprecision(2) << vtkMath::Norm(applied) << " N";
  const std::string why = this->Session->GetSafetyText();
  text << (why.empty() ? "" : ": ") << why;
  if (this->Session->GetState() == vtkHapticSession::DeviceLost)
  {
    text << "\nDevice: " << this->Session->GetDeviceStatus();
  }
  this->Scene->SetRemark(text.str());
}

void vtkInteractorStyleHaptic::OnTimer()
{
  const auto begin = std::chrono::steady_clock::now();
  if (!this->Session || !this->Scene || begin < this->NextFrame)
  {
    return;
  }
  double tip[3];
  double contact[3];
  double normal[3];
  double force[3];
  this->Session->GetTip(tip);
  this->Session->GetContactPoint(contact);
  this->Session->GetNormal(normal);
  this->Session->GetIdealForce(force);
  const vtkIdType cell = this->Session->GetContactCell();
  this->StrongestForce = std::max(this->StrongestForce, vtkMath::Norm(force));
  if (this->ShowsSafety)
  {
    this->TellSafety();
  }
  this->Scene->ShowContact(tip, contact, cell < 0 ? this->HoverNormal : normal, force,
    this->Session->GetDeflection(), cell);
  this->Interactor->Render();
  const auto end = std::chrono::steady_clock::now();
  this->NextFrame = end + (end - begin);
}

void vtkInteractorStyleHaptic::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PressDepth: " << this->PressDepth << " mm\n";
  os << indent << "MaximumDepth: " << this->MaximumDepth << " mm\n";
  os << indent << "HoverHeight: " << this->HoverHeight << " mm\n";
  os << indent << "StrongestForce: " << this->StrongestForce << " N\n";
  os << indent << "Pressing: " << this->Pressing << "\n";
}
