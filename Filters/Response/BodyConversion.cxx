// SPDX-License-Identifier: BSD-3-Clause
#include "Response/BodyConversion.h"

#include "Mechanics/JoinedText.h"
#include "Response/ArrayFetch.h"
#include "Response/FilterThreads.h"
#include "Response/Terms/LawTerm.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
bool fetchNumber(vtkPolyData* body, const std::string& response, ResponseArray which, double low,
  double high, double& value, std::string& error)
{
  const std::string name = arrayName(response, which);
  vtkDataArray* array = body->GetFieldData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfValues() != 1)
  {
    error = "field array '" + name + "' with one value is missing";
    return false;
  }
  value = array->GetTuple1(0);
  if (!(value >= low && value <= high))
  {
    error =
      joined("field array '", name, "' must lie between ", low, " and ", high, ", but is ", value);
    return false;
  }
  return true;
}

/// Fetches the curves in the form that the body has. The form is either Force and Stiffness per
/// point, or Basis and Coefficient.
bool fetchCurves(
  vtkPolyData* body, const std::string& name, ResponseArrays& arrays, std::string& error)
{
  const auto floats = [&](ResponseArray which)
  { return fetchArray<vtkFloatArray>(body, name, which, arrays, error); };
  const std::string basisName = arrayName(name, ResponseArray::Basis);
  vtkAbstractArray* basis = body->GetFieldData()->GetAbstractArray(basisName.c_str());
  if (!basis)
  {
    arrays.force = floats(ResponseArray::Force);
    arrays.stiffness = arrays.force ? floats(ResponseArray::Stiffness) : nullptr;
    return arrays.stiffness != nullptr;
  }
  arrays.laws = static_cast<int>(basis->GetNumberOfTuples());
  if (arrays.laws < 1)
  {
    error = "field array '" + basisName + "' holds no law";
    return false;
  }
  arrays.basis = floats(ResponseArray::Basis);
  arrays.coefficient = arrays.basis ? floats(ResponseArray::Coefficient) : nullptr;
  return arrays.coefficient != nullptr;
}

/// Finds the first triangle with a corner whose point index is not in the range 0 to `points` - 1.
struct FindLostCorner
{
  template <class CellState>
  void operator()(CellState& state, vtkIdType points, vtkIdType& triangle, vtkIdType& corner) const
  {
    const auto* connectivity = state.GetConnectivity();
    const auto isLost = [connectivity, points](vtkIdType i)
    {
      const auto id = static_cast<vtkIdType>(connectivity->GetValue(i));
      return id < 0 || id >= points;
    };
    std::atomic<vtkIdType> first{ std::numeric_limits<vtkIdType>::max() };
    vtkSMPTools::For(0, connectivity->GetNumberOfValues(),
      [&first, &isLost](vtkIdType begin, vtkIdType end)
      {
        vtkIdType i = begin;
        while (i < end && !isLost(i))
        {
          ++i;
        }
        vtkIdType found = first.load();
        while (i < end && i < found && !first.compare_exchange_weak(found, i))
        {
        }
      });
    if (first < connectivity->GetNumberOfValues())
    {
      triangle = first / 3;
      corner = static_cast<vtkIdType>(connectivity->GetValue(first));
    }
  }
};

template <class Array, class Value>
void addFieldValue(
  vtkPolyData* body, const std::string& name, ResponseArray which, const Value& value)
{
  vtkNew<Array> array;
  array->SetName(arrayName(name, which).c_str());
  array->InsertNextValue(value);
  body->GetFieldData()->AddArray(array);
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

vtkFieldData* placeOf(const ContractArray& array, vtkPolyData* body)
{
  return array.place == ContractArray::Place::Points ? body->GetPointData() : body->GetFieldData();
}

void removeArrays(vtkPolyData* body, const std::string& name, ContractArray::Use use)
{
  for (const ContractArray& array : ResponseContract)
  {
    if (array.use == use)
    {
      placeOf(array, body)->RemoveArray(array.named(name).c_str());
    }
  }
}

void removeResponse(vtkPolyData* body, const std::string& name)
{
  for (const ContractArray& array : ResponseContract)
  {
    placeOf(array, body)->RemoveArray(array.named(name).c_str());
  }
}

std::string checkTriangles(vtkPolyData* body)
{
  if (body->GetNumberOfStrips() > 0)
  {
    return joined("the body has ", body->GetNumberOfStrips(),
      " triangle strips; apply Triangulate (vtkTriangleFilter) first");
  }
  if (body->GetNumberOfPolys() == 0)
  {
    return joined("the body has ", body->GetNumberOfPoints(), " points but no triangles");
  }
  if (body->GetPolys()->IsHomogeneous() != 3)
  {
    return "the body has polygons other than triangles; apply Triangulate (vtkTriangleFilter) "
           "first";
  }
  if (body->GetNumberOfPoints() > std::numeric_limits<std::int32_t>::max() ||
    body->GetNumberOfPolys() > std::numeric_limits<std::int32_t>::max())
  {
    return "the body has more than 2^31 points or triangles";
  }
  vtkIdType triangle = -1;
  vtkIdType corner = 0;
  body->GetPolys()->Visit(FindLostCorner{}, body->GetNumberOfPoints(), triangle, corner);
  return triangle < 0 ? std::string()
                      : joined("triangle ", triangle, " has the corner ", corner,
                          ", but the body has points 0 to ", body->GetNumberOfPoints() - 1);
}

std::vector<std::int32_t> copyTriangles(vtkPolyData* body)
{
  std::vector<std::int32_t> triangles;
  body->GetPolys()->Visit(CopyPolys{}, triangles);
  return triangles;
}

std::vector<double> copyPoints(vtkPolyData* body)
{
  const vtkIdType count = body->GetNumberOfPoints();
  std::vector<double> points(3 * static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    body->GetPoint(i, points.data() + 3 * i);
  }
  return points;
}

BodyMesh makeBodyMesh(vtkPolyData* body)
{
  const FilterThreads threads;
  const std::vector<std::int32_t> triangles = copyTriangles(body);
  const std::vector<double> points = copyPoints(body);
  return BodyMesh(points.data(), points.size() / 3, triangles.data(), triangles.size() / 3);
}

bool viewResponse(
  vtkPolyData* body, const std::string& name, ResponseArrays& arrays, std::string& error)
{
  double samples = 0.0;
  if (!fetchNumber(
        body, name, ResponseArray::Samples, 2, ResponseSampling::LargestCount, samples, error) ||
    !fetchNumber(body, name, ResponseArray::Exponent, 0.1, 10.0, arrays.exponent, error))
  {
    return false;
  }
  arrays.samples = static_cast<int>(samples);
  arrays.points = static_cast<std::size_t>(body->GetNumberOfPoints());
  if (!fetchCurves(body, name, arrays, error))
  {
    return false;
  }
  arrays.normal = fetchArray<vtkFloatArray>(body, name, ResponseArray::Normal, arrays, error);
  arrays.range = arrays.normal
    ? fetchArray<vtkFloatArray>(body, name, ResponseArray::Range, arrays, error)
    : nullptr;
  arrays.status = arrays.range
    ? fetchArray<vtkUnsignedCharArray>(body, name, ResponseArray::Status, arrays, error)
    : nullptr;
  return arrays.status &&
    std::all_of(lawTerms().begin(), lawTerms().end(),
      [&](const LawTerm* term) { return term->view(body, name, arrays, error); });
}

bool viewValidity(vtkPolyData* body, const std::string& name, const float*& validity,
  const unsigned char*& limit, std::string& error)
{
  validity = fetchArray<vtkFloatArray>(body, name, ResponseArray::Validity, {}, error);
  limit = validity ? fetchArray<vtkUnsignedCharArray>(body, name, ResponseArray::Limit, {}, error)
                   : nullptr;
  return limit != nullptr;
}

std::unique_ptr<ResponseField> makeResponseField(
  vtkPolyData* body, const std::string& name, std::string& error)
{
  const FilterThreads threads;
  ResponseArrays arrays;
  return viewResponse(body, name, arrays, error) ? std::make_unique<ResponseField>(arrays)
                                                 : nullptr;
}

std::shared_ptr<const ContactBody> makeContactBody(
  vtkPolyData* body, const std::string& name, std::string& error, const BuildProgress& progress)
{
  error = checkTriangles(body);
  if (!error.empty())
  {
    return nullptr;
  }
  ResponseArrays arrays;
  if (!viewResponse(body, name, arrays, error))
  {
    error = "no response '" + name + "' on the body: " + error;
    return nullptr;
  }
  const std::vector<std::int32_t> triangles = copyTriangles(body);
  const std::vector<double> points = copyPoints(body);
  const FilterThreads threads;
  auto made = std::make_shared<const ContactBody>(
    points.data(), points.size() / 3, triangles.data(), triangles.size() / 3, arrays, progress);
  error = made->surface.fault();
  return error.empty() ? made : nullptr;
}

std::shared_ptr<const ContactBody> makeContactBody(vtkPolyData* body, const std::string& name,
  std::string& error, const ContactBody& same, bool isMultiple)
{
  ResponseArrays arrays;
  if (!viewResponse(body, name, arrays, error))
  {
    error = "no response '" + name + "' on the body: " + error;
    return nullptr;
  }
  if (arrays.points != same.surface.inputPointCount())
  {
    error = "the body has " + std::to_string(arrays.points) +
      " points, but its surface must have " + std::to_string(same.surface.inputPointCount());
    return nullptr;
  }
  if (arrays.edges.areFelt() != (same.edges != nullptr))
  {
    // Only one of the two bodies is cut along its sharp edges, so their surfaces differ.
    return makeContactBody(body, name, error);
  }
  arrays.multipleOf = isMultiple ? &same.response : nullptr;
  const FilterThreads threads;
  return std::make_shared<const ContactBody>(same, arrays);
}

void describeResponse(
  vtkPolyData* body, const std::string& name, const ResponseDescription& description)
{
  addFieldValue<vtkDoubleArray>(body, name, ResponseArray::Exponent, description.exponent);
  addFieldValue<vtkIntArray>(body, name, ResponseArray::Samples, description.samples);
  addFieldValue<vtkStringArray>(body, name, ResponseArray::Tool, description.tool);
  describeModel(body, name, { description.model, description.modelParts });
  addFieldValue<vtkStringArray>(body, name, ResponseArray::Units, std::string("mm,N,MPa"));
}

void describeModel(vtkPolyData* body, const std::string& name, const ResponseModel& model)
{
  addFieldValue<vtkStringArray>(body, name, ResponseArray::Model, model.text);
  addFieldValue<vtkUnsignedCharArray>(
    body, name, ResponseArray::ModelParts, static_cast<unsigned char>(model.parts));
}

std::string responseText(vtkPolyData* body, const std::string& name, ResponseArray which)
{
  auto* array = vtkStringArray::SafeDownCast(
    body->GetFieldData()->GetAbstractArray(arrayName(name, which).c_str()));
  return array && array->GetNumberOfValues() > 0 ? array->GetValue(0) : std::string();
}

ResponseModel responseModel(vtkPolyData* body, const std::string& name)
{
  ResponseModel model;
  model.text = responseText(body, name, ResponseArray::Model);
  vtkDataArray* parts =
    body->GetFieldData()->GetArray(arrayName(name, ResponseArray::ModelParts).c_str());
  model.parts = parts && parts->GetNumberOfValues() == 1 ? static_cast<int>(parts->GetTuple1(0))
                                                         : modelPartsOfText(model.text);
  return model;
}
} // namespace palpate
