// SPDX-License-Identifier: BSD-3-Clause
#include "Response/FlatBodyConversion.h"

#include "Response/BodyConversion.h"
#include "Contact/FlatBodyFile.h"
#include "Response/Terms/LawTerm.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <vector>

namespace palpate
{
namespace
{
/// Returns a VTK array with a copy of the values.
template <class Array, class Value>
vtkSmartPointer<Array> copied(
  const std::string& name, const Value* values, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  std::copy_n(values, static_cast<std::size_t>(components * tuples), array->GetPointer(0));
  return array;
}

/// Returns points that are stored as floats if all coordinates are exactly representable as floats.
/// Otherwise returns points that are stored as doubles.
vtkSmartPointer<vtkDataArray> copiedPoints(const double* coordinates, vtkIdType count)
{
  const bool fits = std::all_of(coordinates, coordinates + 3 * count,
    [](double x) { return static_cast<double>(static_cast<float>(x)) == x; });
  if (!fits)
  {
    return copied<vtkDoubleArray>("Points", coordinates, 3, count);
  }
  const std::vector<float> floats(coordinates, coordinates + 3 * count);
  return copied<vtkFloatArray>("Points", floats.data(), 3, count);
}

void addCurves(const FlatBody& flat, const std::string& name, vtkPolyData* body)
{
  const ResponseArrays& response = flat.response;
  const auto count = static_cast<vtkIdType>(flat.points);
  if (response.basis)
  {
    body->GetFieldData()->AddArray(copied<vtkFloatArray>(
      arrayName(name, ResponseArray::Basis), response.basis, 2 * response.samples, response.laws));
    body->GetPointData()->AddArray(copied<vtkFloatArray>(
      arrayName(name, ResponseArray::Coefficient), response.coefficient, response.laws, count));
    return;
  }
  body->GetPointData()->AddArray(copied<vtkFloatArray>(
    arrayName(name, ResponseArray::Force), response.force, response.samples, count));
  body->GetPointData()->AddArray(copied<vtkFloatArray>(
    arrayName(name, ResponseArray::Stiffness), response.stiffness, response.samples, count));
}
} // namespace

std::string writeFlatBody(vtkPolyData* body, const std::string& name, const std::string& path)
{
  std::string error = checkTriangles(body);
  FlatBody flat;
  if (!error.empty() || !viewResponse(body, name, flat.response, error) ||
    !viewValidity(body, name, flat.validity, flat.limit, error))
  {
    return error;
  }
  const std::vector<std::int32_t> corners = copyTriangles(body);
  const std::vector<double> coordinates = copyPoints(body);
  flat.points = flat.response.points;
  flat.triangles = corners.size() / 3;
  flat.coordinates = coordinates.data();
  flat.corners = corners.data();
  flat.tool = responseText(body, name, ResponseArray::Tool);
  const ResponseModel model = responseModel(body, name);
  flat.model = model.text;
  flat.modelParts = model.parts;
  return FlatBodyFile::write(path, flat);
}

vtkSmartPointer<vtkPolyData> readFlatBody(
  const std::string& path, const std::string& name, std::string& error)
{
  FlatBodyFile file;
  error = file.open(path);
  if (!error.empty())
  {
    return nullptr;
  }
  const FlatBody& flat = file.body();
  const auto count = static_cast<vtkIdType>(flat.points);
  const auto triangles = static_cast<vtkIdType>(flat.triangles);
  const std::int32_t* end = flat.corners + 3 * flat.triangles;
  const auto lost = std::find_if(
    flat.corners, end, [count](std::int32_t corner) { return corner < 0 || corner >= count; });
  if (lost != end)
  {
    error = "'" + path + "': triangle " + std::to_string((lost - flat.corners) / 3) +
      " has the corner " + std::to_string(*lost) + ", but there are " + std::to_string(count) +
      " points";
    return nullptr;
  }

  auto body = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetData(copiedPoints(flat.coordinates, count));
  body->SetPoints(points);
  vtkNew<vtkTypeInt32Array> offsets;
  offsets->SetNumberOfValues(triangles + 1);
  for (vtkIdType i = 0; i <= triangles; ++i)
  {
    offsets->SetValue(i, static_cast<int>(3 * i));
  }
  vtkNew<vtkCellArray> polys;
  polys->SetData(
    offsets, copied<vtkTypeInt32Array>("", flat.corners, 1, 3 * triangles).GetPointer());
  body->SetPolys(polys);

  vtkPointData* data = body->GetPointData();
  const ResponseArrays& response = flat.response;
  addCurves(flat, name, body);
  data->AddArray(
    copied<vtkFloatArray>(arrayName(name, ResponseArray::Normal), response.normal, 3, count));
  data->AddArray(
    copied<vtkFloatArray>(arrayName(name, ResponseArray::Range), response.range, 1, count));
  data->AddArray(copied<vtkUnsignedCharArray>(
    arrayName(name, ResponseArray::Status), response.status, 1, count));
  data->AddArray(
    copied<vtkFloatArray>(arrayName(name, ResponseArray::Validity), flat.validity, 1, count));
  data->AddArray(
    copied<vtkUnsignedCharArray>(arrayName(name, ResponseArray::Limit), flat.limit, 1, count));
  describeResponse(
    body, name, { response.exponent, response.samples, flat.tool, flat.model, flat.modelParts });
  for (const LawTerm* term : lawTerms())
  {
    term->describe(body, name, response);
  }
  return body;
}
} // namespace palpate
