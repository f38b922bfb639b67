// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Terms/LawTerm.h"

#include "Contact/Edges/EdgeLaw.h"
#include "Mechanics/Checked.h"
#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Mechanics/Tools/ToolSpecification.h"
#include "Mechanics/JoinedText.h"
#include "Response/ArrayFetch.h"
#include "Response/BodyConversion.h"
#include "Response/ReplacedCurves.h"

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
/// Reads the k values of a field array, where k is 1 to 4. Returns "" or an error message.
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

/// Checks that the values at all points are finite and not negative. Returns "" or an error that
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

/// Sets the exponent and the contact radius of the tool. These values are needed when a contact
/// slides onto new material.
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

/// Reads the Prony series of a response. The series has no branches if the body does not relax. A
/// field array contains k values, either as k tuples or as one tuple. Returns false and an error if
/// an array is invalid.
bool readSeries(vtkPolyData* body, const std::string& name, PronySeries& series, std::string& error)
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
  error = firstFault([&] { return readBranches(strength, strengthName, strengths); },
    [&] { return readBranches(time, timeName, times); });
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

/// Returns whether a value is not negative and can be stored as a float.
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

/// Returns the array of an elastic compliance. Returns null if the compliance relaxes in the same
/// way as the body.
vtkDataArray* elasticCompliance(const LawRequest& request)
{
  const RelaxationRequest& relaxation = request.relaxation;
  return relaxation.series.count > 0 && !relaxation.complianceRelaxes
    ? request.arrays[ComplianceArrayIndex].array
    : nullptr;
}

void addCopy(vtkDataArray* from, const std::string& name, ResponseArray which, vtkPolyData* output)
{
  const int components = from->GetNumberOfComponents();
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(from->GetNumberOfValues()));
  for (vtkIdType i = 0; i < from->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      values.push_back(static_cast<float>(from->GetComponent(i, c)));
    }
  }
  addFloats(output, name, which, components, values);
}

/// The relaxation of the body. The arrays of the term are RelaxationStrength, RelaxationTime,
/// LocalRelaxation and ElasticCompliance. With these arrays, the curves of the response describe
/// the slow force. Without them, the body does not relax.
class RelaxationTerm : public LawTerm
{
public:
  bool isAsked(const LawRequest& request) const override;
  std::string check(const TermBody& response, vtkPolyData* piece) const override;
  std::string make(const TermBody& response, vtkPolyData* output) const override;
  /// Returns a text such as ", relaxing 0.5 in 0.1 s, 0.3 in 2 s".
  ResponseModel words(const TermBody& response) const override;
  /// Also sets the exponent and the contact radius of the tool at the largest range, using the text
  /// in the array Tool. If the tool cannot be read, or cannot be pressed to this depth, the
  /// exponent is that of the curves and the radius is 0.
  bool view(vtkPolyData* body, const std::string& name, ResponseArrays& arrays,
    std::string& error) const override;
  void describe(
    vtkPolyData* body, const std::string& name, const ResponseArrays& arrays) const override;
};
} // namespace

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

bool RelaxationTerm::isAsked(const LawRequest& request) const
{
  return request.relaxation.series.count > 0;
}

std::string RelaxationTerm::check(const TermBody& response, vtkPolyData* piece) const
{
  const RelaxationRequest& relaxation = response.request.relaxation;
  const std::string fault = relaxation.strength.name.empty()
    ? std::string()
    : checkStrengths(piece, relaxation.strength, relaxation.series);
  return fault.empty() && elasticCompliance(response.request)
    ? checkElastic(response.request.arrays[ComplianceArrayIndex])
    : fault;
}

ResponseModel RelaxationTerm::words(const TermBody& response) const
{
  const PronySeries& series = response.request.relaxation.series;
  const bool isLocal = !response.request.relaxation.strength.name.empty();
  std::string text = isLocal ? ", relaxing point by point in " : ", relaxing ";
  for (std::size_t i = 0; i < series.count; ++i)
  {
    text += i > 0 ? ", " : "";
    text += isLocal ? joined(series.time[i], " s")
                    : joined(series.strength[i], " in ", series.time[i], " s");
  }
  return { elasticCompliance(response.request) ? text + ", except its global compliance" : text };
}

std::string RelaxationTerm::make(const TermBody& response, vtkPolyData* output) const
{
  const LawRequest& request = response.request;
  describeRelaxation(output, request.responseName, request.relaxation.series);
  if (vtkDataArray* strength = request.relaxation.strength.array)
  {
    addCopy(strength, request.responseName, ResponseArray::LocalRelaxation, output);
  }
  if (vtkDataArray* compliance = elasticCompliance(request))
  {
    addCopy(compliance, request.responseName, ResponseArray::ElasticCompliance, output);
  }
  return {};
}

void RelaxationTerm::describe(
  vtkPolyData* body, const std::string& name, const ResponseArrays& arrays) const
{
  const RelaxationTerms& terms = arrays.relaxation;
  if (terms.series.count == 0)
  {
    return;
  }
  describeRelaxation(body, name, terms.series);
  const auto add = [&](ResponseArray which, const float* values, std::size_t components)
  {
    if (values)
    {
      addFloats(body, name, which, static_cast<int>(components),
        std::vector<float>(values, values + components * arrays.points));
    }
  };
  add(ResponseArray::LocalRelaxation, terms.strength, terms.series.count);
  add(ResponseArray::ElasticCompliance, terms.elasticCompliance, 1);
}

bool RelaxationTerm::view(
  vtkPolyData* body, const std::string& name, ResponseArrays& arrays, std::string& error) const
{
  RelaxationTerms& terms = arrays.relaxation;
  if (!readSeries(body, name, terms.series, error))
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

const LawTerm& relaxationTerm()
{
  static const RelaxationTerm term;
  return term;
}
} // namespace palpate
