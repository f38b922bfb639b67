// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/ShownContact.h"

#include "Haptics/Safety/SafetyText.h"
#include "Interaction/Session/TickRecording.h"
#include "vtkHapticSession.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace palpate
{
bool readTip(vtkPolyData* probed, vtkIdType index, ShownContact& contact)
{
  vtkPointData* data = probed->GetPointData();
  if (!data->HasArray("Normal") || !readTick(probed, index, 0, contact.tick))
  {
    return false;
  }
  contact.cell = contact.tick.contact.triangle;
  contact.hasApplied = data->HasArray("AppliedForce") != 0;
  if (contact.hasApplied && data->HasArray("SafetyLinks") && data->HasArray("ForceFactor"))
  {
    contact.safety = describeSafety(contact.tick.acted, contact.tick.forceFactor);
  }
  return true;
}

ShownContact readSession(vtkHapticSession* session, int hand)
{
  ShownContact contact;
  contact.tick = session->GetNewestTick(hand); // a copy: the thread goes on
  const Tick& tick = contact.tick;
  vtkPolyData* body = session->GetBody();
  // A tick of the body before may still be on its way.
  if (body && tick.contact.triangle >= 0 && tick.contact.triangle < body->GetNumberOfPolys())
  {
    contact.cell = body->GetNumberOfVerts() + body->GetNumberOfLines() + tick.contact.triangle;
  }
  contact.hasOthers = session->GetNumberOfDevices() > 1;
  vtkHapticDevice* device = session->GetDevice(hand);
  const bool inputOnly = device->IsPhysical() && !device->GetOutputsForce();
  const int state = session->GetState(hand);
  if (state != vtkHapticSession::Stopped && !inputOnly)
  {
    contact.hasApplied = true;
    contact.safety = describeSafety(tick.acted, tick.forceFactor);
    if (state != vtkHapticSession::Running)
    {
      contact.tick.appliedForce.setZero();
      contact.safety += ", device " + device->GetStatus();
    }
  }
  return contact;
}
} // namespace palpate
