// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Curves/PointNormals.h"

#include "Mechanics/JoinedText.h"
#include "Response/BodyConversion.h"
#include "Response/Pieces/BodySeam.h"
#include "Response/Pieces/SeamNormals.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace palpate
{
namespace
{
/// If the length of a vector differs from 1 by less than this value, which is float rounding, the
/// vector is kept unchanged. Therefore normals that were read from a file are bitwise preserved.
constexpr double UnitTolerance = 3e-7;

constexpr double NormalTolerance = 0.035; // 2 degrees, in rad

/// Stores the unit vector along (x, y, z), or zero if the length of the vector is 0. Returns the
/// status of the point.
ResponseStatus storeUnit(double x, double y, double z, float* normal)
{
  double length = std::sqrt(x * x + y * y + z * z);
  if (std::abs(length - 1.0) < UnitTolerance)
  {
    length = 1.0;
  }
  if (length > 0.0 && std::isfinite(length))
  {
    normal[0] = static_cast<float>(x / length);
    normal[1] = static_cast<float>(y / length);
    normal[2] = static_cast<float>(z / length);
    return ResponseStatus::Valid;
  }
  normal[0] = normal[1] = normal[2] = 0.0F;
  return length == 0.0 ? ResponseStatus::Degenerate : ResponseStatus::NotFinite;
}

double angleBetween(const Vector3& one, const Vector3& other)
{
  return std::atan2(one.cross(other).norm(), one.dot(other));
}

/// Returns whether the stored normals belong to the triangles. Each stored normal must differ from
/// the computed normal by at most 2 degrees plus the largest angle between the computed normals of
/// the point and a neighbour. Exact normals can differ from computed normals by this angle.
bool areOfTriangles(vtkPolyData* body, vtkDataArray* stored, const float* computed)
{
  const auto at = [computed](std::int32_t i)
  { return Vector3(Eigen::Map<const Eigen::Vector3f>(computed + 3 * i).cast<double>()); };
  const auto count = static_cast<std::int32_t>(body->GetNumberOfPoints());
  std::vector<float> allowed(static_cast<std::size_t>(count), 0.0F);
  const std::vector<std::int32_t> corners = copyTriangles(body);
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const std::int32_t from = corners[i];
    const std::int32_t to = corners[i % 3 == 2 ? i - 2 : i + 1];
    const auto turn = static_cast<float>(angleBetween(at(from), at(to)));
    for (const std::int32_t end : { from, to })
    {
      float& most = allowed[static_cast<std::size_t>(end)];
      most = std::max(most, turn);
    }
  }
  for (std::int32_t i = 0; i < count; ++i)
  {
    Vector3 given;
    stored->GetTuple(i, given.data());
    const double most = NormalTolerance + static_cast<double>(allowed[static_cast<std::size_t>(i)]);
    if (!at(i).isZero(0.0) && !(given.norm() > 0.0 && angleBetween(at(i), given) <= most))
    {
      return false;
    }
  }
  return true;
}

/// Sets the status and the normal of points whose coordinates are not finite.
void markNotFinite(vtkPoints* points, float* normals, unsigned char* status)
{
  vtkSMPTools::For(0, points->GetNumberOfPoints(),
    [=](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        double p[3];
        points->GetPoint(i, p);
        if (!std::isfinite(p[0] + p[1] + p[2]))
        {
          status[i] = static_cast<unsigned char>(ResponseStatus::NotFinite);
          normals[3 * i] = normals[3 * i + 1] = normals[3 * i + 2] = 0.0F;
        }
      }
    });
}

unsigned char storeNormal(const Vector3& normal, float* at)
{
  return static_cast<unsigned char>(storeUnit(normal.x(), normal.y(), normal.z(), at));
}

void computeNormals(vtkPolyData* body, float* normals, unsigned char* status)
{
  const std::vector<std::int32_t> triangles = copyTriangles(body);
  const std::vector<double> points = copyPoints(body);
  const std::vector<double> found =
    angleWeightedNormals(points.data(), points.size() / 3, triangles.data(), triangles.size() / 3);
  for (std::size_t i = 0; i < found.size(); i += 3)
  {
    status[i / 3] = storeNormal(Eigen::Map<const Vector3>(found.data() + i), normals + i);
  }
}

/// Computes the normals of a body with a seam. Returns an error if a closed surface is inside out.
std::string computeNormals(
  vtkPolyData* body, const BodySeam& seam, float* normals, unsigned char* status)
{
  const BodyMesh mesh = makeBodyMesh(body);
  const SeamClosure closure = closureOf(mesh, seam);
  if (closure.isClosed && closure.enclosedVolume < 0.0)
  {
    return joined("the closed surface is inside out (it encloses ", closure.enclosedVolume,
      " mm^3): its triangles must wind counter-clockwise seen from outside; vtkReverseSense turns "
      "them");
  }
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    status[i] = storeNormal(mesh.pointNormal(static_cast<std::int32_t>(i)), normals + 3 * i);
  }
  const std::vector<Vector3> atSeam = seamNormals(mesh, seam);
  for (std::size_t i = 0; i < atSeam.size(); ++i)
  {
    const std::int32_t point = seam.places()[i].point;
    status[point] = storeNormal(atSeam[i], normals + 3 * static_cast<vtkIdType>(point));
  }
  return {};
}
} // namespace

std::string fillPointNormals(
  vtkPolyData* body, const BodySeam& seam, vtkFloatArray* normals, vtkUnsignedCharArray* status)
{
  float* normal = normals->GetPointer(0);
  unsigned char* state = status->GetPointer(0);
  std::string wrongSide;
  if (seam.ranks().areAlone())
  {
    // This call never fails, because a SoundBody does not wind inward.
    computeNormals(body, normal, state);
  }
  else
  {
    wrongSide = computeNormals(body, seam, normal, state);
  }
  if (!wrongSide.empty())
  {
    return wrongSide;
  }
  vtkDataArray* stored = body->GetPointData()->GetNormals();
  const bool isEmpty = body->GetNumberOfPoints() == 0;
  if (!seam.ranks().any(!isEmpty && !(stored && areOfTriangles(body, stored, normal))))
  {
    for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
    {
      double given[3];
      stored->GetTuple(i, given);
      if (state[i] == static_cast<unsigned char>(ResponseStatus::Valid))
      {
        storeUnit(given[0], given[1], given[2], normal + 3 * i);
      }
    }
  }
  if (!isEmpty)
  {
    markNotFinite(body->GetPoints(), normal, state);
  }
  return {};
}

std::string fillPointNormals(
  vtkPolyData* body, vtkFloatArray* normals, vtkUnsignedCharArray* status)
{
  return fillPointNormals(body, BodySeam(Ranks(nullptr), body), normals, status);
}
} // namespace palpate
