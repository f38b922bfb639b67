// SPDX-License-Identifier: BSD-3-Clause
#include "Pieces/GatheredBody.h"

#include "Pieces/BodyPiece.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <unordered_map>

namespace palpate
{
namespace
{
/// Maps the points of the parts to points of the body. The first part that has a seam point adds it
/// to the body. Later parts use the same point of the body.
class Numbering
{
public:
  std::vector<vtkIdType> numbersOf(vtkPolyData* part, vtkIdList* news, vtkIdType& next)
  {
    std::vector<vtkIdType> numbers;
    std::unordered_map<int, vtkIdType> here;
    vtkDataArray* seams = part->GetPointData()->GetArray(BodyPiece::SeamArray);
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      const int seam = seams ? static_cast<int>(seams->GetTuple1(i)) : -1;
      const auto known = this->Seams.find(seam);
      if (seam >= 0 && known != this->Seams.end())
      {
        numbers.push_back(known->second);
        continue;
      }
      if (seam >= 0)
      {
        here.emplace(seam, next); // other parts may share the point, but not this part
      }
      news->InsertNextId(i);
      numbers.push_back(next++);
    }
    this->Seams.insert(here.begin(), here.end());
    return numbers;
  }

private:
  std::unordered_map<int, vtkIdType> Seams;
};

void append(vtkPolyData* part, vtkIdList* ids, const std::string& name, vtkPolyData* body)
{
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    body->GetPoints()->InsertNextPoint(part->GetPoint(ids->GetId(i)));
  }
  for (const ContractArray& contract : ResponseContract)
  {
    vtkDataArray* from = contract.isEvaluated() && contract.place == ContractArray::Place::Points
      ? part->GetPointData()->GetArray(contract.named(name).c_str())
      : nullptr;
    if (!from || ids->GetNumberOfIds() == 0)
    {
      continue;
    }
    vtkDataArray* to = body->GetPointData()->GetArray(from->GetName());
    if (!to)
    {
      auto made = vtkSmartPointer<vtkDataArray>::Take(from->NewInstance());
      made->SetName(from->GetName());
      made->SetNumberOfComponents(from->GetNumberOfComponents());
      body->GetPointData()->AddArray(made);
      to = made;
    }
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      to->InsertNextTuple(ids->GetId(i), from);
    }
  }
}
} // namespace

GatheredBody::GatheredBody(
  const std::vector<vtkSmartPointer<vtkPolyData>>& parts, const std::string& name)
  : Body(vtkSmartPointer<vtkPolyData>::New())
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  this->Body->SetPoints(points);
  this->Body->SetPolys(vtkNew<vtkCellArray>());
  Numbering numbering;
  vtkIdType next = 0;
  for (std::size_t rank = 0; rank < parts.size(); ++rank)
  {
    vtkPolyData* part = parts[rank];
    if (!part || part->GetNumberOfPolys() == 0)
    {
      continue;
    }
    vtkNew<vtkIdList> news;
    const std::vector<vtkIdType> numbers = numbering.numbersOf(part, news, next);
    append(part, news, name, this->Body);
    vtkDataArray* cells = part->GetCellData()->GetArray(BodyPiece::CellArray);
    vtkNew<vtkIdList> corners;
    for (vtkIdType t = 0; t < part->GetNumberOfPolys(); ++t)
    {
      part->GetPolys()->GetCellAtId(t, corners);
      for (vtkIdType k = 0; k < 3; ++k)
      {
        corners->SetId(k, numbers[static_cast<std::size_t>(corners->GetId(k))]);
      }
      this->Body->GetPolys()->InsertNextCell(corners);
      this->Origins.push_back(
        { static_cast<int>(rank), static_cast<vtkIdType>(cells->GetTuple1(t)) });
    }
    if (this->Body->GetFieldData()->GetNumberOfArrays() == 0)
    {
      this->Body->GetFieldData()->ShallowCopy(part->GetFieldData());
    }
  }
}
} // namespace palpate
