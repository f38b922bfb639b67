// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/ShownContact.h"

#include "Haptics/Safety/SafetyText.h"
#include "Interaction/Session/TickRecording.h"
#include "Response/Curves/StoredError.h"
#include "vtkHapticSession.h"

#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
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

namespace
{
/// Returns the cell of the contact of a tick, or -1 if the tick belongs to an earlier body.
vtkIdType cellOf(vtkPolyData* body, const Tick& tick)
{
  const vtkIdType triangle = tick.contact.triangle;
  return body && triangle >= 0 && triangle < body->GetNumberOfPolys()
    ? body->GetNumberOfVerts() + body->GetNumberOfLines() + triangle
    : -1;
}
} // namespace

ShownContact contactOfTick(vtkHapticSession* session, const Tick& tick)
{
  ShownContact contact;
  contact.tick = tick;
  contact.cell = cellOf(session->GetBody(), tick);
  findValidity(session->GetBody(), session->GetResponseName(), contact);
  return contact;
}

ShownContact readSession(vtkHapticSession* session, int hand, const Eigen::Vector3d& freeDirection)
{
  ShownContact contact;
  contact.tick = session->GetNewestTick(hand); // a copy is used, because the servo thread continues
  const Tick& tick = contact.tick;
  vtkPolyData* body = session->GetBody();
  contact.cell = cellOf(body, tick);
  contact.hasOthers = session->GetNumberOfDevices() > 1;
  vtkHapticDevice* device = session->GetDevice(hand);
  const bool inputOnly = device->IsPhysical() && !device->GetOutputsForce();
  const int state = session->GetState(hand);
  if (state != vtkHapticSession::Stopped && !inputOnly)
  {
    contact.hasApplied = true;
    contact.safety = describeSafety(tick.acted, tick.forceFactor, session->GetFitReason());
    if (state != vtkHapticSession::Running)
    {
      contact.tick.appliedForce.setZero();
      contact.safety += ", device " + device->GetStatus();
    }
  }
  if (!contact.touches())
  {
    contact.tick.contact.normal = freeDirection;
  }
  findValidity(body, session->GetResponseName(), contact);
  return contact;
}

ShownContact contactOfNumbers(const double tip[3], const double contactPoint[3],
  const double normal[3], const double force[3], double deflection, vtkIdType cell)
{
  ShownContact contact;
  contact.tick.tip = Eigen::Vector3d(tip);
  contact.tick.idealForce = Eigen::Vector3d(force);
  contact.tick.contact.contactPoint = Eigen::Vector3d(contactPoint);
  contact.tick.contact.normal = Eigen::Vector3d(normal);
  contact.tick.contact.deflection = deflection;
  contact.cell = cell;
  return contact;
}

void findValidity(vtkPolyData* body, const std::string& responseName, ShownContact& contact)
{
  contact.validity = std::numeric_limits<double>::infinity();
  contact.limit = 0;
  contact.error = std::numeric_limits<double>::quiet_NaN();
  if (!body || !contact.touches() || contact.cell >= body->GetNumberOfCells())
  {
    return;
  }
  vtkDataArray* validity =
    body->GetPointData()->GetArray(arrayName(responseName, ResponseArray::Validity).c_str());
  vtkDataArray* limit =
    body->GetPointData()->GetArray(arrayName(responseName, ResponseArray::Limit).c_str());
  if (!validity || !limit)
  {
    return;
  }
  contact.error =
    StoredError(body, responseName)
      .at(contact.cell, contact.tick.contact.contactPoint.data(), contact.tick.contact.deflection);
  vtkNew<vtkIdList> corners;
  body->GetCellPoints(contact.cell, corners);
  for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
  {
    const vtkIdType corner = corners->GetId(i);
    if (validity->GetTuple1(corner) < contact.validity)
    {
      contact.validity = validity->GetTuple1(corner);
      contact.limit = static_cast<int>(limit->GetTuple1(corner));
    }
  }
}
} // namespace palpate
