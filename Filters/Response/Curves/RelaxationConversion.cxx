// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Curves/RelaxationConversion.h"

#include "Contact/Edges/EdgeLaw.h"
#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Mechanics/Tools/ToolSpecification.h"
#include "Response/ArrayFetch.h"
#include "Response/BodyConversion.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>

namespace palpate
{
namespace
{
/// Reads the k values of a field array, 1 to 4. Returns "" or an error message.
std::string readBranches(vtkDataArray* array, const std::string& name, std::vector<double>& values)
{
  const vtkIdType count = array->GetNumberOfValues();
  if ((array->GetNumberOfComponents() != 1 && array->GetNumberOfTuples() != 1) || count < 1 ||
    count > static_cast<vtkIdType>(PronySeries::LargestCount))
  {
    return joined("field array '", name, "' must hold 1 to ", PronySeries::LargestCount,
      " values, one a tuple, but is ", shapeOf(array));
  }
  const int components = array->GetNumberOfComponents();
  for (vtkIdType i = 0; i < count; ++i)
  {
    values.push_back(array->GetComponent(i / components, static_cast<int>(i % components)));
  }
  return {};
}

bool isStrength(double value)
{
  return value >= 0.0 && std::isfinite(value);
}

/// Checks values of points, which must be finite and not negative. Returns "" or an error that
/// names the first invalid value.
std::string checkValues(const std::string& name, const float* values, std::size_t points,
  std::size_t components, const char* quantity, const char* unit)
{
  for (std::size_t i = 0; i < points * components; ++i)
  {
    const double value{ values[i] };
    if (!isStrength(value))
    {
      const std::string which = components > 1 ? joined(" ", i % components + 1) : std::string();
      return joined("array '", name, "': ", quantity, which, " of point ", i / components,
        " must be finite and not negative", unit, ", but is ", value);
    }
  }
  return {};
}

/// Exponent and contact radius of the tool, for a contact that slides onto new material.
void describeContact(const std::string& text, double range, RelaxationTerms& terms)
{
  ToolSpecification specification;
  std::string reason;
  if (!(range > 0.0) || !parseTool(text, specification, reason))
  {
    return;
  }
  const std::unique_ptr<AxisymmetricTool> tool = makeTool(specification);
  if (!tool || !tool->checkDepth(range).empty())
  {
    return;
  }
  const EdgeTerms pressed = edgeTermsOf(*tool, range, 0.5);
  if (std::isfinite(pressed.exponent) && std::isfinite(pressed.radius) && pressed.radius > 0.0)
  {
    terms.exponent = pressed.exponent;
    terms.radius = pressed.radius;
  }
}
} // namespace

bool relaxationOf(
  vtkPolyData* body, const std::string& name, PronySeries& series, std::string& error)
{
  series = {};
  const std::string strengthName = arrayName(name, ResponseArray::RelaxationStrength);
  const std::string timeName = arrayName(name, ResponseArray::RelaxationTime);
  vtkDataArray* strength = body->GetFieldData()->GetArray(strengthName.c_str());
  vtkDataArray* time = body->GetFieldData()->GetArray(timeName.c_str());
  std::string other;
  for (const ContractArray& array : ResponseContract)
  {
    const std::string full = array.named(name);
    if (array.use == ContractArray::Use::Relaxation && other.empty() &&
      placeOf(array, body)->HasArray(full.c_str()))
    {
      other = full;
    }
  }
  if (other.empty())
  {
    return true;
  }
  if (!strength || !time)
  {
    error = "field array '" + (strength ? timeName : strengthName) +
      "' of numbers is missing, but '" + other + "' is there";
    return false;
  }
  std::vector<double> strengths;
  std::vector<double> times;
  error = readBranches(strength, strengthName, strengths);
  error = error.empty() ? readBranches(time, timeName, times) : error;
  if (error.empty() && strengths.size() != times.size())
  {
    error = joined("field array '", strengthName, "' has ", strengths.size(), " values, but '",
      timeName, "' has ", times.size());
  }
  for (std::size_t i = 0; i < strengths.size() && error.empty(); ++i)
  {
    if (!isStrength(strengths[i]))
    {
      error = joined("field array '", strengthName, "': value ", i,
        " must be finite and not negative, but is ", strengths[i]);
    }
    else if (!(times[i] > 0.0) || !std::isfinite(times[i]))
    {
      error = joined("field array '", timeName, "': value ", i,
        " must be finite and above 0 s, but is ", times[i]);
    }
    else
    {
      series.add(strengths[i], times[i]);
    }
  }
  return error.empty();
}

void describeRelaxation(vtkPolyData* body, const std::string& name, const PronySeries& series)
{
  const auto add = [&](ResponseArray which, const auto& values)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(arrayName(name, which).c_str());
    for (std::size_t i = 0; i < series.count; ++i)
    {
      array->InsertNextValue(values[i]);
    }
    body->GetFieldData()->AddArray(array);
  };
  add(ResponseArray::RelaxationStrength, series.strength);
  add(ResponseArray::RelaxationTime, series.time);
}

bool viewRelaxation(
  vtkPolyData* body, const std::string& name, ResponseArrays& arrays, std::string& error)
{
  RelaxationTerms& terms = arrays.relaxation;
  if (!relaxationOf(body, name, terms.series, error))
  {
    return false;
  }
  if (terms.series.count == 0)
  {
    return true;
  }
  const auto fetch = [&](ResponseArray which, const float*& values)
  {
    const bool isThere = body->GetPointData()->HasArray(arrayName(name, which).c_str());
    values = isThere ? fetchArray<vtkFloatArray>(body, name, which, arrays, error) : nullptr;
    return !isThere || values;
  };
  if (!fetch(ResponseArray::LocalRelaxation, terms.strength) ||
    !fetch(ResponseArray::ElasticCompliance, terms.elasticCompliance))
  {
    return false;
  }
  if (terms.strength)
  {
    error = checkValues(arrayName(name, ResponseArray::LocalRelaxation), terms.strength,
      arrays.points, terms.series.count, "relaxation", "");
  }
  if (error.empty() && terms.elasticCompliance)
  {
    error = checkValues(arrayName(name, ResponseArray::ElasticCompliance), terms.elasticCompliance,
      arrays.points, 1, "elastic compliance", " (mm/N)");
  }
  terms.exponent = arrays.exponent;
  if (error.empty())
  {
    describeContact(responseText(body, name, ResponseArray::Tool), arrays.longestRange(), terms);
  }
  return error.empty();
}
} // namespace palpate
