// SPDX-License-Identifier: BSD-3-Clause
#include "Response/BodyChoice.h"

#include "Contact/Reduction/ChoiceReason.h"
#include "Laws/CouplingNeed.h"
#include "Mechanics/Checked.h"
#include "Mechanics/JoinedText.h"
#include "Response/BodyConversion.h"
#include "Response/FilterThreads.h"
#include "Response/Curves/AutomaticTerms.h"
#include "Response/ReplacedCurves.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace palpate
{
namespace
{
/// Replaces the curves by the chosen laws.
void replaceCurves(vtkPolyData* body, const std::string& name, const ResponseChoice& choice)
{
  removeCurves(body, name);
  const int columns = static_cast<int>(choice.basis.size()) / choice.laws;
  addFloats(body, name, ResponseArray::Basis, columns, choice.basis);
  addFloats(body, name, ResponseArray::Coefficient, choice.laws, choice.coefficient);
  if (choice.need == ResponseNeed::PointForce)
  {
    vtkNew<vtkDoubleArray> exponent;
    exponent->SetName(arrayName(name, ResponseArray::Exponent).c_str());
    exponent->InsertNextValue(choice.exponent);
    body->GetFieldData()->AddArray(exponent);
    const ResponseModel model = responseModel(body, name);
    describeModel(body, name, { model.text + "; as a spring per point", model.parts | SpringPart });
  }
}

std::string capitalised(std::string words)
{
  words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
  return words;
}

/// Stores the number of elements that the relaxation needs. Removes the array if the relaxation has
/// a negligible effect.
void keepRelaxation(vtkPolyData* body, const std::string& name, const RelaxationTerms& terms,
  const RelaxationNeed& need)
{
  const std::string elementsName = arrayName(name, ResponseArray::RelaxationElements);
  body->GetFieldData()->RemoveArray(elementsName.c_str());
  if (terms.series.count > 0 && !need.isFelt)
  {
    removeArrays(body, name, ContractArray::Use::Relaxation);
    return;
  }
  if (terms.series.count > 0)
  {
    vtkNew<vtkIntArray> elements;
    elements->SetName(elementsName.c_str());
    elements->InsertNextValue(need.elements);
    body->GetFieldData()->AddArray(elements);
  }
}

/// Reads the verdicts of the regime and the validities, if the body has them. Returns "" or an
/// error message.
std::string readEvidence(vtkPolyData* body, const std::string& name, ChoiceEvidence& evidence)
{
  vtkPointData* points = body->GetPointData();
  if (vtkAbstractArray* found = points->GetAbstractArray("RegimeVerdict"))
  {
    auto* verdict = vtkUnsignedCharArray::SafeDownCast(found);
    if (!verdict || verdict->GetNumberOfComponents() != 1)
    {
      return joined("Array 'RegimeVerdict' must be unsigned char with 1 component, but is ",
        found->GetDataTypeAsString(), " with ", found->GetNumberOfComponents());
    }
    evidence.verdict = verdict->GetPointer(0);
  }
  std::string error;
  if (points->HasArray(arrayName(name, ResponseArray::Validity).c_str()))
  {
    viewValidity(body, name, evidence.validity, evidence.limit, error);
  }
  return error;
}

/// Chooses the depth (mm) at which regime and validity are checked; 0 means half of Range. Returns
/// "" or an error message.
std::string chooseDepth(vtkPolyData* body, const ResponseArrays& arrays, double& depth)
{
  vtkDataArray* at = body->GetFieldData()->GetArray("RegimeDeflection");
  if (!at || at->GetNumberOfValues() != 1 || !body->GetPointData()->HasArray("RegimeVerdict"))
  {
    return {};
  }
  const double found = at->GetTuple1(0);
  if (depth == 0.0)
  {
    // If RegimeDeflection is half of the largest Range, the regime was computed for the default
    // depth, half of Range at each point. In this case the depth is also set to its default, 0.
    const double longest = *std::max_element(arrays.range, arrays.range + arrays.points);
    depth = std::abs(found - 0.5 * longest) <= 1e-6 * longest ? 0.0 : found;
    return {};
  }
  return std::abs(found - depth) <= 1e-6 * depth
    ? std::string()
    : joined("RegimeVerdict is that of ", found, " mm (RegimeDeflection), but Deflection is ",
        depth, " mm");
}

std::string checkSettings(const ChoiceSettings& settings)
{
  if (!(settings.tolerance > 0.0))
  {
    return joined("Tolerance must be above 0, but is ", settings.tolerance);
  }
  if (!(settings.share > 0.0 && settings.share <= 1.0))
  {
    return joined(
      "Fraction Of Points Within Tolerance (Share) must be above 0 and at most 1, but is ",
      settings.share);
  }
  if (!(settings.depth >= 0.0 && std::isfinite(settings.depth)))
  {
    return joined("Deflection must be finite and not negative (mm), but is ", settings.depth);
  }
  if (settings.mostLaws < 1 || settings.mostLaws > 16)
  {
    return joined("Maximum Number Of Laws must lie between 1 and 16, but is ", settings.mostLaws);
  }
  return {};
}
} // namespace

std::string attachChoice(vtkPolyData* body, const std::string& responseName,
  const ChoiceSettings& settings, vtkPolyData* output, AttachedChoice& attached)
{
  ResponseArrays arrays;
  ChoiceEvidence evidence;
  ChoiceSettings used = settings;
  const std::string fault = firstFault([&] { return checkSettings(settings); },
    [&]
    {
      std::string missing;
      return viewResponse(body, responseName, arrays, missing)
        ? std::string()
        : "No response '" + responseName + "' on the body: " + missing;
    },
    [&] { return readEvidence(body, responseName, evidence); },
    [&] { return chooseDepth(body, arrays, used.depth); });
  if (!fault.empty())
  {
    return fault;
  }
  const FilterThreads threads;
  attached.choice = chooseResponse(arrays, evidence, used);
  attached.numbersPerPointBefore = arrays.basis ? arrays.laws : 2 * arrays.samples;
  attached.reason = choiceReason(attached.choice, used, attached.numbersPerPointBefore);
  RelaxationTerms& relaxation = arrays.relaxation;
  relaxation.exponent =
    attached.choice.need == ResponseNeed::PointForce ? 1.0 : relaxation.exponent;
  attached.relaxation = relaxationNeed(relaxation, arrays.points, used.tolerance);
  const std::string time = relaxationReason(attached.relaxation, relaxation.series, used.tolerance);
  attached.reason += time.empty() ? time : ". " + capitalised(time);
  attached.tilt = tiltNeed(arrays, used.tolerance);
  const std::string tilts = tiltReason(attached.tilt, arrays.tilt, used.tolerance);
  attached.reason += tilts.empty() ? tilts : ". " + capitalised(tilts);
  const CouplingNeed coupling = couplingNeed(arrays, used.tolerance);
  const std::string others = couplingReason(coupling, arrays.coupling, used.tolerance);
  attached.reason += others.empty() ? others : ". " + capitalised(others);
  const std::string terms = termsReason(body, responseName);
  attached.reason += terms.empty() ? terms : ". Terms of its law: " + terms;
  copyWithOwnFields(body, output);
  if (attached.choice.need != ResponseNeed::PerVertex)
  {
    replaceCurves(output, responseName, attached.choice);
  }
  addText(output, responseName, ResponseArray::Choice, attached.reason);
  keepRelaxation(output, responseName, relaxation, attached.relaxation);
  if (!attached.tilt.isFelt)
  {
    removeArrays(output, responseName, ContractArray::Use::Tilt);
  }
  if (!coupling.isFelt)
  {
    removeArrays(output, responseName, ContractArray::Use::Coupling);
  }
  return {};
}
} // namespace palpate
