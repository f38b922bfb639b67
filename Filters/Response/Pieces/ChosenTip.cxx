// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Pieces/ChosenTip.h"

#include "Response/Pieces/Ranks.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <array>
#include <vector>

namespace palpate
{
namespace
{
/// Reads the contact of the tip `index`. Returns "" or an error that names the missing array.
std::string readTip(vtkPolyData* tips, vtkIdType index, const Ranks& ranks, ChosenTip& chosen)
{
  vtkPointData* data = tips->GetPointData();
  vtkDataArray* cells = data->GetArray("ContactCell");
  vtkDataArray* deflections = data->GetArray("Deflection");
  vtkDataArray* points = data->GetArray("ContactPoint");
  vtkDataArray* normals = data->GetArray("Normal");
  if (!cells || !deflections || !points || !normals || points->GetNumberOfComponents() != 3 ||
    normals->GetNumberOfComponents() != 3)
  {
    return "Tips (input port 1) must be the output of Tool Contact Probe (vtkToolContactProbe): "
           "ContactCell, Deflection, ContactPoint(3) or Normal(3) is missing";
  }
  FieldContact& contact = chosen.contact;
  contact.cell = static_cast<vtkIdType>(cells->GetTuple1(index));
  contact.deflection = deflections->GetTuple1(index);
  points->GetTuple(index, contact.point.data());
  normals->GetTuple(index, contact.normal.data());
  vtkDataArray* forces = data->GetArray("NormalForce");
  contact.force = forces ? forces->GetTuple1(index) : 0.0;
  if (ranks.areAlone() || contact.cell < 0)
  {
    return {};
  }
  vtkDataArray* places = data->GetArray("ContactRank");
  if (!places)
  {
    return "port 1 has no array ContactRank: the tips must be probed on the same processes";
  }
  chosen.rank = static_cast<int>(places->GetTuple1(index));
  if (chosen.rank < 0 || chosen.rank >= ranks.count())
  {
    return "ContactRank of tip " + std::to_string(index) + " is " + std::to_string(chosen.rank) +
      ", but there are " + std::to_string(ranks.count()) + " processes";
  }
  return {};
}

/// Copies the data to all ranks from the rank that has read them.
void broadcast(const Ranks& ranks, bool isOwn, ChosenTip& chosen)
{
  using Record = std::array<double, 10>;
  const FieldContact& own = chosen.contact;
  const Record record{ static_cast<double>(own.cell), static_cast<double>(chosen.rank),
    own.deflection, own.force, own.point.x(), own.point.y(), own.point.z(), own.normal.x(),
    own.normal.y(), own.normal.z() };
  for (const auto& each :
    ranks.gather(isOwn ? std::vector<Record>{ record } : std::vector<Record>{}))
  {
    for (const Record& r : each)
    {
      chosen.contact = { static_cast<vtkIdType>(r[0]), r[2], r[3], Vector3(r[4], r[5], r[6]),
        Vector3(r[7], r[8], r[9]) };
      chosen.rank = static_cast<int>(r[1]);
    }
  }
}
} // namespace

std::string chooseTip(const Ranks& ranks, vtkPolyData* tips, vtkIdType index, ChosenTip& chosen)
{
  const vtkIdType own = tips ? tips->GetNumberOfPoints() : 0;
  vtkIdType count = 0;
  vtkIdType first = 0;
  const auto all = ranks.gather(std::vector<vtkIdType>{ own });
  for (std::size_t rank = 0; rank < all.size(); ++rank)
  {
    first = static_cast<int>(rank) == ranks.own() ? count : first;
    count += all[rank].front();
  }
  if (count == 0)
  {
    return {};
  }
  const vtkIdType tip = index < 0 ? count - 1 : index;
  if (tip >= count)
  {
    return "Tip Index " + std::to_string(tip) + " is beyond the last of " + std::to_string(count) +
      " tips";
  }
  const bool isOwn = tip >= first && tip < first + own;
  const std::string fault =
    ranks.firstFault(isOwn ? readTip(tips, tip - first, ranks, chosen) : std::string());
  if (fault.empty() && !ranks.areAlone())
  {
    broadcast(ranks, isOwn, chosen);
  }
  return fault;
}
} // namespace palpate
