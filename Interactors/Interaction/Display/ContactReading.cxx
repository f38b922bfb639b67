// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/ContactReading.h"

#include "Haptics/Safety/SafetyText.h"
#include "Haptics/Servo/ServoStep.h"
#include "vtkHapticSession.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cstdint>

namespace palpate
{
bool readTip(vtkPolyData* probed, vtkIdType index, ShownContact& contact)
{
  vtkPointData* data = probed->GetPointData();
  vtkDataArray* force = data->GetArray("Force");
  vtkDataArray* normal = data->GetArray("Normal");
  vtkDataArray* point = data->GetArray("ContactPoint");
  vtkDataArray* deflection = data->GetArray("Deflection");
  vtkDataArray* cell = data->GetArray("ContactCell");
  if (!force || !normal || !point || !deflection || !cell || index < 0 ||
    index >= probed->GetNumberOfPoints())
  {
    return false;
  }
  probed->GetPoint(index, contact.tip.data());
  force->GetTuple(index, contact.force.data());
  normal->GetTuple(index, contact.normal.data());
  point->GetTuple(index, contact.contactPoint.data());
  contact.deflection = deflection->GetTuple1(index);
  contact.cell = static_cast<vtkIdType>(cell->GetTuple1(index));
  if (vtkDataArray* friction = data->GetArray("FrictionForce"))
  {
    friction->GetTuple(index, contact.friction.data());
  }
  if (vtkDataArray* state = data->GetArray("ContactState"))
  {
    contact.state = static_cast<int>(state->GetTuple1(index));
  }
  if (vtkDataArray* applied = data->GetArray("AppliedForce"))
  {
    applied->GetTuple(index, contact.applied.data());
    contact.hasApplied = true;
  }
  vtkDataArray* links = data->GetArray("SafetyLinks");
  vtkDataArray* factor = data->GetArray("ForceFactor");
  if (contact.hasApplied && links && factor)
  {
    contact.safety =
      describeSafety(static_cast<std::uint16_t>(links->GetTuple1(index)), factor->GetTuple1(index));
  }
  return true;
}

ShownContact readSession(vtkHapticSession* session)
{
  const ServoTick tick = session->GetNewestTick(); // a copy: the thread goes on
  ShownContact contact;
  contact.tip = tick.tip;
  contact.contactPoint = tick.contact.contactPoint;
  contact.normal = tick.contact.normal;
  contact.force = tick.idealForce;
  contact.friction = tick.contact.friction;
  contact.deflection = tick.contact.deflection;
  contact.state = static_cast<int>(tick.contact.state);
  vtkPolyData* body = session->GetBody();
  // A tick of the body before may still be on its way.
  if (body && tick.contact.triangle >= 0 && tick.contact.triangle < body->GetNumberOfPolys())
  {
    contact.cell = body->GetNumberOfVerts() + body->GetNumberOfLines() + tick.contact.triangle;
  }
  const bool inputOnly = session->IsDevicePhysical() && !session->GetDeviceOutputsForce();
  const int state = session->GetState();
  if (state != vtkHapticSession::Stopped && !inputOnly)
  {
    contact.hasApplied = true;
    contact.safety = describeSafety(tick.acted, tick.forceFactor);
    if (state == vtkHapticSession::Running)
    {
      contact.applied = tick.appliedForce;
    }
    else
    {
      contact.safety += ", device " + session->GetDeviceStatus();
    }
  }
  return contact;
}
} // namespace palpate
