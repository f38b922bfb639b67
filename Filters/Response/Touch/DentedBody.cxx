// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Touch/DentedBody.h"

#include "Response/BodyField.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <vector>

namespace palpate
{
namespace
{
/// Smallest ratio of displacement to edge length at which normals are rotated. Below this ratio the
/// rotation is invisible.
constexpr double VisibleTurn = 1e-3;

using FacetCorners = std::array<Vector3, 3>;

Vector3 facetNormal(const FacetCorners& corners)
{
  // The length of this vector is twice the area.
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]);
}

/// Calls `use` with the corner ids of each triangle.
template <class Use>
void forEachTriangle(vtkPolyData* body, const Use& use)
{
  vtkCellArray* triangles = body->GetPolys();
  for (vtkIdType i = 0; i < triangles->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    triangles->GetCellAtId(i, size, ids);
    if (size == 3)
    {
      use(ids);
    }
  }
}

Vector3 motionOf(vtkFloatArray* displacement, vtkIdType point)
{
  return Eigen::Map<const Eigen::Vector3f>(displacement->GetPointer(3 * point)).cast<double>();
}

/// Returns the sum of all dents. If there is a single dent, returns its array; otherwise returns a
/// new array.
vtkSmartPointer<vtkFloatArray> sumOf(const std::vector<Dent>& dents)
{
  if (dents.size() == 1)
  {
    return dents.front().displacement;
  }
  const auto sum = vtkSmartPointer<vtkFloatArray>::New();
  sum->DeepCopy(dents.front().displacement);
  for (std::size_t k = 1; k < dents.size(); ++k)
  {
    addDisplacements(dents[k].displacement, sum);
  }
  return sum;
}

/// Rotates the normals together with the facets. Returns the new normals, or null if no normal
/// changes.
vtkSmartPointer<vtkDataArray> turnNormals(
  vtkPolyData* body, vtkDataArray* normals, vtkPoints* before, vtkFloatArray* displacement)
{
  const auto moved = [displacement](vtkIdType id)
  { return Eigen::Map<const Eigen::Vector3f>(displacement->GetPointer(3 * id)); };
  const auto isTurnVisible = [&](const vtkIdType* ids)
  {
    const Eigen::Vector3f u = moved(ids[0]);
    const Eigen::Vector3f v = moved(ids[1]);
    const Eigen::Vector3f w = moved(ids[2]);
    const float turn = std::max((u - v).squaredNorm(), (u - w).squaredNorm());
    if (turn == 0.0F)
    {
      return false;
    }
    Vector3 a;
    Vector3 b;
    before->GetPoint(ids[0], a.data());
    before->GetPoint(ids[1], b.data());
    return static_cast<double>(turn) > VisibleTurn * VisibleTurn * (a - b).squaredNorm();
  };
  std::vector<char> turned(static_cast<std::size_t>(body->GetNumberOfPoints()), 0);
  bool any = false;
  forEachTriangle(body,
    [&](const vtkIdType* ids)
    {
      if (isTurnVisible(ids))
      {
        any = true;
        for (int k = 0; k < 3; ++k)
        {
          turned[static_cast<std::size_t>(ids[k])] = 1;
        }
      }
    });
  if (!any)
  {
    return nullptr;
  }
  std::vector<Vector3> undeformed(turned.size(), Vector3::Zero());
  std::vector<Vector3> deformed(turned.size(), Vector3::Zero());
  forEachTriangle(body,
    [&](const vtkIdType* ids)
    {
      const auto isTurned = [&](int k) { return turned[static_cast<std::size_t>(ids[k])] != 0; };
      if (!isTurned(0) && !isTurned(1) && !isTurned(2))
      {
        return;
      }
      FacetCorners old;
      FacetCorners now;
      for (std::size_t k = 0; k < 3; ++k)
      {
        before->GetPoint(ids[k], old[k].data());
        now[k] = old[k] + moved(ids[k]).cast<double>();
      }
      const Vector3 was = facetNormal(old);
      const Vector3 is = facetNormal(now);
      for (int k = 0; k < 3; ++k)
      {
        undeformed[static_cast<std::size_t>(ids[k])] += was;
        deformed[static_cast<std::size_t>(ids[k])] += is;
      }
    });
  const auto result = vtkSmartPointer<vtkDataArray>::Take(normals->NewInstance());
  result->DeepCopy(normals);
  for (std::size_t i = 0; i < turned.size(); ++i)
  {
    if (turned[i] != 0)
    {
      Vector3 normal;
      result->GetTuple(static_cast<vtkIdType>(i), normal.data());
      const double length = normal.norm();
      normal += length * (deformed[i].normalized() - undeformed[i].normalized());
      normal *= normal.norm() > 0.0 ? length / normal.norm() : 1.0;
      result->SetTuple(static_cast<vtkIdType>(i), normal.data());
    }
  }
  return result;
}
} // namespace

void dentBody(vtkPolyData* body, const std::vector<Dent>& dents)
{
  const vtkIdType count = body->GetNumberOfPoints();
  const auto displacement = sumOf(dents);
  vtkPoints* before = body->GetPoints();
  vtkNew<vtkPoints> after;
  after->SetDataType(before->GetDataType());
  after->DeepCopy(before);
  vtkNew<vtkFloatArray> dent;
  dent->SetName("Dent (mm)");
  dent->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Vector3 moved = motionOf(displacement, i);
    double depth = 0.0; // the initial value 0 avoids a result of -0
    for (const Dent& made : dents)
    {
      depth -= motionOf(made.displacement, i).dot(made.normal);
    }
    dent->SetValue(i, static_cast<float>(depth));
    if (!moved.isZero(0.0))
    {
      Vector3 point;
      before->GetPoint(i, point.data());
      point += moved;
      after->SetPoint(i, point.data());
    }
  }
  vtkPointData* data = body->GetPointData();
  if (vtkDataArray* normals = data->GetNormals())
  {
    if (const auto turned = turnNormals(body, normals, before, displacement))
    {
      data->SetNormals(turned); // this replaces the old point normals
    }
  }
  body->SetPoints(after);
  data->AddArray(displacement);
  data->AddArray(dent);
  data->SetActiveScalars(dent->GetName());
}
} // namespace palpate
