// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/ContactValidity.h"

#include "Response/Curves/StoredError.h"

#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace palpate
{
void findValidity(vtkPolyData* body, const std::string& responseName, ShownContact& contact)
{
  contact.validity = std::numeric_limits<double>::infinity();
  contact.limit = 0;
  contact.error = std::numeric_limits<double>::quiet_NaN();
  if (!body || !contact.touches() || contact.cell >= body->GetNumberOfCells())
  {
    return;
  }
  vtkDataArray* validity = body->GetPointData()->GetArray(
    palpate::arrayName(responseName, palpate::ResponseArray::Validity).c_str());
  vtkDataArray* limit = body->GetPointData()->GetArray(
    palpate::arrayName(responseName, palpate::ResponseArray::Limit).c_str());
  if (!validity || !limit)
  {
    return;
  }
  const StoredError errors(body, responseName);
  vtkNew<vtkIdList> corners;
  body->GetCellPoints(contact.cell, corners);
  for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
  {
    const vtkIdType corner = corners->GetId(i);
    const double error = errors.at(corner, contact.tick.contact.deflection);
    contact.error = error > contact.error || i == 0 ? error : contact.error;
    if (validity->GetTuple1(corner) < contact.validity)
    {
      contact.validity = validity->GetTuple1(corner);
      contact.limit = static_cast<int>(limit->GetTuple1(corner));
    }
  }
}
} // namespace palpate
