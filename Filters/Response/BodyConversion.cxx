// SPDX-License-Identifier: BSD-3-Clause
#include "BodyConversion.h"

#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
constexpr int LargestSampleCount = 256;

std::string describe(vtkAbstractArray* array)
{
  std::ostringstream text;
  text << array->GetDataTypeAsString() << " with " << array->GetNumberOfComponents()
       << " components and " << array->GetNumberOfTuples() << " tuples";
  return text.str();
}

/// The memory of a contract array, or null with an error unless it has exactly this type and shape.
template <class Array>
const typename Array::ValueType* fetch(vtkFieldData* data, const std::string& name,
  const char* typeName, int components, vtkIdType tuples, std::string& error)
{
  vtkAbstractArray* found = data->GetAbstractArray(name.c_str());
  if (!found)
  {
    error = "array '" + name + "' is missing";
    return nullptr;
  }
  Array* array = Array::FastDownCast(found);
  if (!array || array->GetNumberOfComponents() != components ||
    array->GetNumberOfTuples() != tuples)
  {
    std::ostringstream text;
    text << "array '" << name << "' must be " << typeName << " with " << components
         << " components and " << tuples << " tuples, but is " << describe(found);
    error = text.str();
    return nullptr;
  }
  return array->GetPointer(0);
}

bool fetchNumber(vtkPolyData* body, const std::string& name, double low, double high, double& value,
  std::string& error)
{
  vtkDataArray* array = body->GetFieldData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfValues() != 1)
  {
    error = "field array '" + name + "' with one value is missing";
    return false;
  }
  value = array->GetTuple1(0);
  if (!(value >= low && value <= high))
  {
    std::ostringstream text;
    text << "field array '" << name << "' must lie between " << low << " and " << high
         << ", but is " << value;
    error = text.str();
    return false;
  }
  return true;
}

/// Per-point Force and Stiffness, or Basis and Coefficient.
bool fetchCurves(
  vtkPolyData* body, const std::string& name, ResponseArrays& arrays, std::string& error)
{
  vtkPointData* points = body->GetPointData();
  const vtkIdType count = body->GetNumberOfPoints();
  vtkAbstractArray* basis = body->GetFieldData()->GetAbstractArray((name + "Basis").c_str());
  if (!basis)
  {
    arrays.force =
      fetch<vtkFloatArray>(points, name + "Force", "float", arrays.samples, count, error);
    arrays.stiffness = arrays.force
      ? fetch<vtkFloatArray>(points, name + "Stiffness", "float", arrays.samples, count, error)
      : nullptr;
    return arrays.stiffness != nullptr;
  }
  arrays.laws = static_cast<int>(basis->GetNumberOfTuples());
  if (arrays.laws < 1)
  {
    error = "field array '" + name + "Basis' holds no law";
    return false;
  }
  arrays.basis = fetch<vtkFloatArray>(body->GetFieldData(), name + "Basis", "float",
    2 * arrays.samples, basis->GetNumberOfTuples(), error);
  arrays.coefficient = arrays.basis
    ? fetch<vtkFloatArray>(points, name + "Coefficient", "float", arrays.laws, count, error)
    : nullptr;
  return arrays.coefficient != nullptr;
}

struct CopyPolys
{
  template <class CellState>
  void operator()(CellState& state, std::vector<std::int32_t>& triangles) const
  {
    const auto* connectivity = state.GetConnectivity();
    const vtkIdType size = connectivity->GetNumberOfValues();
    triangles.resize(static_cast<std::size_t>(size));
    for (vtkIdType i = 0; i < size; ++i)
    {
      triangles[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(connectivity->GetValue(i));
    }
  }
};
} // namespace

std::string checkTriangles(vtkPolyData* body)
{
  std::ostringstream text;
  if (body->GetNumberOfStrips() > 0)
  {
    text << "the body has " << body->GetNumberOfStrips()
         << " triangle strips; pass it through vtkTriangleFilter first";
  }
  else if (body->GetNumberOfPolys() == 0)
  {
    text << "the body has " << body->GetNumberOfPoints() << " points but no triangles";
  }
  else if (body->GetPolys()->IsHomogeneous() != 3)
  {
    text << "the body has polygons other than triangles; pass it through vtkTriangleFilter first";
  }
  else if (body->GetNumberOfPoints() > std::numeric_limits<std::int32_t>::max() ||
    body->GetNumberOfPolys() > std::numeric_limits<std::int32_t>::max())
  {
    text << "the body has more than 2^31 points or triangles";
  }
  return text.str();
}

BodyMesh makeBodyMesh(vtkPolyData* body)
{
  std::vector<std::int32_t> triangles;
  body->GetPolys()->Visit(CopyPolys{}, triangles);
  const vtkIdType count = body->GetNumberOfPoints();
  std::vector<double> points(3 * static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    body->GetPoint(i, points.data() + 3 * i);
  }
  return BodyMesh(
    points.data(), static_cast<std::size_t>(count), triangles.data(), triangles.size() / 3);
}

std::unique_ptr<ResponseField> makeResponseField(
  vtkPolyData* body, const std::string& name, std::string& error)
{
  double samples = 0.0;
  ResponseArrays arrays;
  if (!fetchNumber(body, name + "Samples", 2, LargestSampleCount, samples, error) ||
    !fetchNumber(body, name + "Exponent", 0.1, 10.0, arrays.exponent, error))
  {
    return nullptr;
  }
  arrays.samples = static_cast<int>(samples);
  arrays.points = static_cast<std::size_t>(body->GetNumberOfPoints());
  const vtkIdType count = body->GetNumberOfPoints();
  vtkPointData* points = body->GetPointData();
  if (!fetchCurves(body, name, arrays, error))
  {
    return nullptr;
  }
  arrays.normal = fetch<vtkFloatArray>(points, name + "Normal", "float", 3, count, error);
  arrays.range = arrays.normal
    ? fetch<vtkFloatArray>(points, name + "Range", "float", 1, count, error)
    : nullptr;
  arrays.status = arrays.range
    ? fetch<vtkUnsignedCharArray>(points, name + "Status", "unsigned char", 1, count, error)
    : nullptr;
  return arrays.status ? std::make_unique<ResponseField>(arrays) : nullptr;
}

std::shared_ptr<const ContactBody> makeContactBody(
  vtkPolyData* body, const std::string& name, std::string& error)
{
  error = checkTriangles(body);
  if (!error.empty())
  {
    return nullptr;
  }
  std::unique_ptr<ResponseField> response = makeResponseField(body, name, error);
  if (!response)
  {
    error = "no response '" + name + "' on the body: " + error;
    return nullptr;
  }
  return std::make_shared<const ContactBody>(makeBodyMesh(body), std::move(*response));
}

std::string responseText(vtkPolyData* body, const std::string& name, const char* suffix)
{
  auto* array =
    vtkStringArray::SafeDownCast(body->GetFieldData()->GetAbstractArray((name + suffix).c_str()));
  return array && array->GetNumberOfValues() > 0 ? array->GetValue(0) : std::string();
}
} // namespace palpate
