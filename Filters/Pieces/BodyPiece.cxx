// SPDX-License-Identifier: BSD-3-Clause
#include "Pieces/BodyPiece.h"

#include "Response/BodyConversion.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace palpate
{
namespace
{
/// Copies the arrays that are needed to evaluate the response, for the points `ids` of `from`, to
/// `to`.
void copyResponse(vtkPolyData* from, const std::string& name, vtkIdList* ids, vtkPolyData* to)
{
  for (const ContractArray& contract : ResponseContract)
  {
    vtkDataArray* array = contract.isEvaluated()
      ? placeOf(contract, from)->GetArray(contract.named(name).c_str())
      : nullptr;
    if (array && contract.place == ContractArray::Place::Fields)
    {
      to->GetFieldData()->AddArray(array);
    }
    else if (array)
    {
      auto part = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
      part->SetName(array->GetName());
      part->SetNumberOfComponents(array->GetNumberOfComponents());
      part->SetNumberOfTuples(ids->GetNumberOfIds());
      array->GetTuples(ids, part);
      to->GetPointData()->AddArray(part);
    }
  }
}
} // namespace

BodyPiece::BodyPiece(vtkPolyData* body, const BodySeam& seam)
  : Body(body)
  , Points(copyPoints(body))
  , Triangles(copyTriangles(body))
  , Finite(this->Triangles.size() / 3, 0)
  , Seam(this->Points.size() / 3, -1)
  , Used(vtkSmartPointer<vtkPolyData>::New())
{
  for (const BodySeam::Place& place : seam.places())
  {
    this->Seam[static_cast<std::size_t>(place.point)] = place.seam;
  }
  std::vector<char> used(this->Seam.size(), 0);
  for (std::size_t t = 0; t < this->Finite.size(); ++t)
  {
    const std::int32_t* corner = this->Triangles.data() + 3 * t;
    const Vector3 x[3] = { this->point(corner[0]), this->point(corner[1]), this->point(corner[2]) };
    if (!(x[0] + x[1] + x[2]).allFinite())
    {
      continue;
    }
    this->Finite[t] = 1;
    for (std::size_t k = 0; k < 3; ++k)
    {
      used[static_cast<std::size_t>(corner[k])] = 1;
      this->Box.extend(x[k]);
      this->LongestEdge = std::max(this->LongestEdge, (x[(k + 1) % 3] - x[k]).norm());
    }
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    if (used[i])
    {
      points->InsertNextPoint(this->Points.data() + 3 * i);
      this->UsedIds.push_back(static_cast<std::int32_t>(i));
    }
  }
  this->Used->SetPoints(points);
  if (!this->UsedIds.empty())
  {
    this->Locator->SetDataSet(this->Used);
    this->Locator->BuildLocator();
  }
}

BodyPiece::~BodyPiece() = default;

double BodyPiece::nearest(const Vector3& tip) const
{
  if (this->UsedIds.empty() || !tip.allFinite())
  {
    return std::numeric_limits<double>::infinity();
  }
  const vtkIdType found = this->Locator->FindClosestPoint(tip.data());
  Vector3 x;
  this->Used->GetPoint(found, x.data());
  return (x - tip).norm();
}

std::vector<char> BodyPiece::markPoints(const std::vector<TipBall>& balls, double margin) const
{
  std::vector<char> marked(this->Seam.size(), 0);
  vtkNew<vtkIdList> found;
  for (const TipBall& ball : balls)
  {
    const double radius = ball.radius + margin;
    if (this->UsedIds.empty() || !(radius < std::numeric_limits<double>::infinity()))
    {
      std::fill(marked.begin(), marked.end(), 1);
      break;
    }
    this->Locator->FindPointsWithinRadius(radius, ball.centre, found);
    for (vtkIdType i = 0; i < found->GetNumberOfIds(); ++i)
    {
      const auto used = static_cast<std::size_t>(found->GetId(i));
      marked[static_cast<std::size_t>(this->UsedIds[used])] = 1;
    }
  }
  return marked;
}

void BodyPiece::keepExtremes(const Eigen::AlignedBox3d& whole, std::vector<char>& kept) const
{
  for (Eigen::Index axis = 0; axis < 3 && !this->Box.isEmpty(); ++axis)
  {
    for (const bool upper : { false, true })
    {
      const double face = upper ? whole.max()[axis] : whole.min()[axis];
      const double own = upper ? this->Box.max()[axis] : this->Box.min()[axis];
      std::size_t t = own == face ? 0 : kept.size();
      const auto reaches = [&](std::size_t triangle)
      {
        const std::int32_t* corner = this->Triangles.data() + 3 * triangle;
        return this->Finite[triangle] &&
          std::any_of(
            corner, corner + 3, [&](std::int32_t id) { return this->point(id)[axis] == face; });
      };
      while (t < kept.size() && !reaches(t))
      {
        ++t;
      }
      if (t < kept.size())
      {
        kept[t] = 1;
      }
    }
  }
}

vtkSmartPointer<vtkPolyData> BodyPiece::cut(const std::vector<TipBall>& balls, double margin,
  const Eigen::AlignedBox3d& whole, const std::string& name) const
{
  auto part = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkIdList> ids;
  vtkNew<vtkIntArray> seams;
  seams->SetName(SeamArray);
  vtkNew<vtkIntArray> cells;
  cells->SetName(CellArray);
  if (!balls.empty())
  {
    const std::vector<char> marked = this->markPoints(balls, margin);
    std::vector<char> kept(this->Finite.size(), 0);
    for (std::size_t t = 0; t < kept.size(); ++t)
    {
      const std::int32_t* corner = this->Triangles.data() + 3 * t;
      kept[t] = this->Finite[t] &&
        std::any_of(corner, corner + 3,
          [&marked](std::int32_t id) { return marked[static_cast<std::size_t>(id)] != 0; });
    }
    this->keepExtremes(whole, kept);
    const auto firstPoly =
      static_cast<int>(this->Body->GetNumberOfVerts() + this->Body->GetNumberOfLines());
    std::vector<vtkIdType> number(this->Seam.size(), -1);
    for (std::size_t t = 0; t < kept.size(); ++t)
    {
      if (!kept[t])
      {
        continue;
      }
      vtkIdType corners[3];
      for (std::size_t k = 0; k < 3; ++k)
      {
        const auto id = static_cast<std::size_t>(this->Triangles[3 * t + k]);
        if (number[id] < 0)
        {
          number[id] = points->InsertNextPoint(this->Points.data() + 3 * id);
          ids->InsertNextId(static_cast<vtkIdType>(id));
          seams->InsertNextValue(this->Seam[id]);
        }
        corners[k] = number[id];
      }
      polys->InsertNextCell(3, corners);
      cells->InsertNextValue(firstPoly + static_cast<int>(t));
    }
  }
  part->SetPoints(points);
  part->SetPolys(polys);
  copyResponse(this->Body, name, ids, part);
  part->GetPointData()->AddArray(seams);
  part->GetCellData()->AddArray(cells);
  return part;
}
} // namespace palpate
