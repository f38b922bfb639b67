// SPDX-License-Identifier: BSD-3-Clause
#include "PointNormals.h"

#include "BodyConversion.h"

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

namespace palpate
{
namespace
{
/// A vector that differs from unit length by float rounding alone is kept to the bit: normals that
/// come back from a file are the ones that were written.
constexpr double UnitTolerance = 3e-7;

/// Writes the unit vector along (x, y, z); anything else becomes zero with its status.
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
} // namespace

std::string fillPointNormals(
  vtkPolyData* body, vtkFloatArray* normals, vtkUnsignedCharArray* status)
{
  float* normal = normals->GetPointer(0);
  unsigned char* state = status->GetPointer(0);
  if (vtkDataArray* given = body->GetPointData()->GetNormals())
  {
    forReals(given, Normalise{}, normal, state);
  }
  else
  {
    const BodyMesh mesh = makeBodyMesh(body);
    if (mesh.isClosed() && mesh.enclosedVolume() < 0.0)
    {
      std::ostringstream text;
      text << "the closed surface is inside out (it encloses " << mesh.enclosedVolume()
           << " mm^3): its triangles must wind counter-clockwise seen from outside; "
              "vtkReverseSense turns them";
      return text.str();
    }
    for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
    {
      const Vector3 unit = mesh.pointNormal(static_cast<std::int32_t>(i));
      state[i] =
        static_cast<unsigned char>(storeUnit(unit.x(), unit.y(), unit.z(), normal + 3 * i));
    }
  }
  forReals(body->GetPoints()->GetData(), MarkNotFinite{}, normal, state);
  return {};
}
} // namespace palpate
