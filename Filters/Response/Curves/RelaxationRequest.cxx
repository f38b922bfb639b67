// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Curves/RelaxationRequest.h"

#include "Mechanics/JoinedText.h"
#include "Response/BodyConversion.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>

namespace palpate
{
namespace
{
/// Whether a value is not negative and can be stored as a float.
bool isStorable(double value)
{
  return value >= 0.0 && std::isfinite(static_cast<float>(value));
}

std::string checkStrengths(
  vtkPolyData* body, const MaterialArray& strength, const PronySeries& series)
{
  const auto& [name, array] = strength;
  const auto branches = static_cast<int>(series.count);
  if (!array)
  {
    return missingArray(name, RelaxationArrayIndex);
  }
  if (branches == 0)
  {
    return joined("Array '", name,
      "' has strengths of relaxations, but there is no relaxation: add rows to Relaxations "
      "(AddRelaxation)");
  }
  if (array->GetNumberOfComponents() != branches ||
    array->GetNumberOfTuples() != body->GetNumberOfPoints())
  {
    return joined("Array '", name, "' must have a component for each of the ", branches,
      " relaxations and ", body->GetNumberOfPoints(), " tuples, but has ",
      array->GetNumberOfComponents(), " and ", array->GetNumberOfTuples());
  }
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < branches; ++c)
    {
      if (!isStorable(array->GetComponent(i, c)))
      {
        return joined("Array '", name, "': strength of relaxation ", c + 1, " of point ", i,
          " must be finite and not negative, but is ", array->GetComponent(i, c));
      }
    }
  }
  return {};
}

std::string checkElastic(const MaterialArray& compliance)
{
  const auto& [name, array] = compliance;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    if (!isStorable(array->GetComponent(i, 0)))
    {
      return joined("Array '", name, "': global compliance of point ", i,
        " must not be negative (mm/N) with Compliance Relaxes off, but is ",
        array->GetComponent(i, 0));
    }
  }
  return {};
}

bool isElastic(const RelaxationRequest& request, const MaterialArray& compliance)
{
  return request.series.count > 0 && !request.complianceRelaxes && compliance.array;
}

void addCopy(vtkDataArray* from, const std::string& name, ResponseArray which, vtkPolyData* output)
{
  vtkNew<vtkFloatArray> copy;
  copy->SetNumberOfComponents(from->GetNumberOfComponents());
  copy->SetNumberOfTuples(from->GetNumberOfTuples());
  for (vtkIdType i = 0; i < from->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < from->GetNumberOfComponents(); ++c)
    {
      copy->SetTypedComponent(i, c, static_cast<float>(from->GetComponent(i, c)));
    }
  }
  copy->SetName(arrayName(name, which).c_str());
  output->GetPointData()->AddArray(copy);
}
} // namespace

std::string checkRelaxation(
  vtkPolyData* body, const RelaxationRequest& request, const MaterialArray& compliance)
{
  const std::string fault = request.strength.name.empty()
    ? std::string()
    : checkStrengths(body, request.strength, request.series);
  return fault.empty() && isElastic(request, compliance) ? checkElastic(compliance) : fault;
}

std::string relaxationInWords(const RelaxationRequest& request, const MaterialArray& compliance)
{
  const PronySeries& series = request.series;
  if (series.count == 0)
  {
    return {};
  }
  const bool isLocal = !request.strength.name.empty();
  std::string words = isLocal ? ", relaxing point by point in " : ", relaxing ";
  for (std::size_t i = 0; i < series.count; ++i)
  {
    words += i > 0 ? ", " : "";
    words += isLocal ? joined(series.time[i], " s")
                     : joined(series.strength[i], " in ", series.time[i], " s");
  }
  return isElastic(request, compliance) ? words + ", except its global compliance" : words;
}

void attachRelaxation(const RelaxationRequest& request, const MaterialArray& compliance,
  const std::string& name, vtkPolyData* output)
{
  removeArrays(output, name, ContractArray::Use::Relaxation);
  if (request.series.count == 0)
  {
    return;
  }
  describeRelaxation(output, name, request.series);
  if (request.strength.array)
  {
    addCopy(request.strength.array, name, ResponseArray::LocalRelaxation, output);
  }
  if (isElastic(request, compliance))
  {
    addCopy(compliance.array, name, ResponseArray::ElasticCompliance, output);
  }
}
} // namespace palpate
