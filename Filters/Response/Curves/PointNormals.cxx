// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Curves/PointNormals.h"

#include "Response/BodyConversion.h"
#include "Response/Pieces/BodySeam.h"
#include "Response/Pieces/SeamNormals.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArrayRange.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <sstream>
#include <vector>

namespace palpate
{
namespace
{
/// A vector that differs from unit length by float rounding alone is kept to the bit, so that
/// normals read from a file are those that were written.
constexpr double UnitTolerance = 3e-7;

/// Writes the unit vector along (x, y, z), or zero if there is none; returns the status.
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

struct Normalise
{
  template <class Array>
  void operator()(Array* given, float* normals, unsigned char* status) const
  {
    const auto source = vtk::DataArrayTupleRange<3>(given);
    vtkSMPTools::For(0, given->GetNumberOfTuples(),
      [&source, normals, status](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          const auto n = source[i];
          status[i] = static_cast<unsigned char>(storeUnit(static_cast<double>(n[0]),
            static_cast<double>(n[1]), static_cast<double>(n[2]), normals + 3 * i));
        }
      });
  }
};

struct MarkNotFinite
{
  template <class Array>
  void operator()(Array* given, float* normals, unsigned char* status) const
  {
    const auto points = vtk::DataArrayTupleRange<3>(given);
    vtkSMPTools::For(0, given->GetNumberOfTuples(),
      [&points, normals, status](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          const auto p = points[i];
          if (!std::isfinite(
                static_cast<double>(p[0]) + static_cast<double>(p[1]) + static_cast<double>(p[2])))
          {
            status[i] = static_cast<unsigned char>(ResponseStatus::NotFinite);
            normals[3 * i] = normals[3 * i + 1] = normals[3 * i + 2] = 0.0F;
          }
        }
      });
  }
};

template <class Worker>
void forReals(vtkDataArray* array, const Worker& worker, float* normals, unsigned char* status)
{
  using Dispatcher = vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Reals>;
  if (!Dispatcher::Execute(array, worker, normals, status))
  {
    worker(array, normals, status);
  }
}

unsigned char storeNormal(const Vector3& normal, float* at)
{
  return static_cast<unsigned char>(storeUnit(normal.x(), normal.y(), normal.z(), at));
}

/// Angle-weighted normals; an error for a closed surface inside out.
std::string computeNormals(
  vtkPolyData* body, const BodySeam& seam, float* normals, unsigned char* status)
{
  const BodyMesh mesh = makeBodyMesh(body);
  SeamClosure closure;
  if (!seam.ranks().areAlone())
  {
    closure = closureOf(mesh, seam);
  }
  else if (mesh.isClosed())
  {
    closure = { true, mesh.enclosedVolume() };
  }
  if (closure.isClosed && closure.enclosedVolume < 0.0)
  {
    std::ostringstream text;
    text << "the closed surface is inside out (it encloses " << closure.enclosedVolume
         << " mm^3): its triangles must wind counter-clockwise seen from outside; "
            "vtkReverseSense turns them";
    return text.str();
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
  vtkDataArray* given = body->GetPointData()->GetNormals();
  const Ranks& ranks = seam.ranks();
  const bool isEmpty = body->GetNumberOfPoints() == 0;
  if (ranks.any(given && !isEmpty))
  {
    const std::string without = ranks.firstFault(
      given || isEmpty ? "" : "a piece of the body has no point normals, others have");
    if (!without.empty())
    {
      return without;
    }
    if (!isEmpty)
    {
      forReals(given, Normalise{}, normal, state);
    }
  }
  else
  {
    const std::string wrongSide = computeNormals(body, seam, normal, state);
    if (!wrongSide.empty())
    {
      return wrongSide;
    }
  }
  if (!isEmpty)
  {
    forReals(body->GetPoints()->GetData(), MarkNotFinite{}, normal, state);
  }
  return {};
}

std::string fillPointNormals(
  vtkPolyData* body, vtkFloatArray* normals, vtkUnsignedCharArray* status)
{
  return fillPointNormals(body, BodySeam(Ranks(nullptr), body), normals, status);
}
} // namespace palpate
