// SPDX-License-Identifier: BSD-3-Clause
#include "vtkResponseChoice.h"

#include "Response/BodyConversion.h"
#include "Contact/Reduction/ChoiceReason.h"
#include "Response/FilterThreads.h"
#include "Response/ReplacedCurves.h"
#include "Contact/Reduction/ResponseChoice.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace
{
using palpate::ResponseArray;
using palpate::ResponseNeed;

static_assert(static_cast<int>(ResponseNeed::PointForce) == vtkResponseChoice::PointForce &&
  static_cast<int>(ResponseNeed::PerVertex) == vtkResponseChoice::PerVertex);

/// The laws in place of the curves there were.
void replaceCurves(
  vtkPolyData* body, const std::string& name, const palpate::ResponseChoice& choice)
{
  palpate::removeCurves(body, name);
  const int columns = static_cast<int>(choice.basis.size()) / choice.laws;
  palpate::addFloats(body, name, ResponseArray::Basis, columns, choice.basis);
  palpate::addFloats(body, name, ResponseArray::Coefficient, choice.laws, choice.coefficient);
  if (choice.need == ResponseNeed::PointForce)
  {
    vtkNew<vtkDoubleArray> exponent;
    exponent->SetName(palpate::arrayName(name, ResponseArray::Exponent).c_str());
    exponent->InsertNextValue(choice.exponent);
    body->GetFieldData()->AddArray(exponent);
    const palpate::ResponseModel model = palpate::responseModel(body, name);
    palpate::describeModel(
      body, name, { model.text + "; as a spring per point", model.parts | palpate::SpringPart });
  }
}

/// Verdicts of the regime, and validities, where they are on the body; "" or what is wrong with
/// them.
std::string readEvidence(
  vtkPolyData* body, const std::string& name, palpate::ChoiceEvidence& evidence)
{
  vtkPointData* points = body->GetPointData();
  if (vtkAbstractArray* found = points->GetAbstractArray("RegimeVerdict"))
  {
    auto* verdict = vtkUnsignedCharArray::SafeDownCast(found);
    if (!verdict || verdict->GetNumberOfComponents() != 1)
    {
      return "Array 'RegimeVerdict' must be unsigned char with 1 component, but is " +
        std::string(found->GetDataTypeAsString()) + " with " +
        std::to_string(found->GetNumberOfComponents());
    }
    evidence.verdict = verdict->GetPointer(0);
  }
  std::string error;
  if (points->HasArray(palpate::arrayName(name, ResponseArray::Validity).c_str()))
  {
    palpate::viewValidity(body, name, evidence.validity, evidence.limit, error);
  }
  return error;
}

/// The depth (mm) that regime and validity are looked at; 0 for half of Range. "" or what is wrong.
std::string chooseDepth(vtkPolyData* body, const palpate::ResponseArrays& arrays, double& depth)
{
  vtkDataArray* at = body->GetFieldData()->GetArray("RegimeDeflection");
  if (!at || at->GetNumberOfValues() != 1 || !body->GetPointData()->HasArray("RegimeVerdict"))
  {
    return {};
  }
  const double found = at->GetTuple1(0);
  if (depth == 0.0)
  {
    // The largest, where the regime followed Range; as it is done here without it.
    const double longest = *std::max_element(arrays.range, arrays.range + arrays.points);
    depth = std::abs(found - 0.5 * longest) <= 1e-6 * longest ? 0.0 : found;
    return {};
  }
  std::ostringstream text;
  text << "RegimeVerdict is that of " << found << " mm (RegimeDeflection), but Deflection is "
       << depth << " mm";
  return std::abs(found - depth) <= 1e-6 * depth ? std::string() : text.str();
}
} // namespace

vtkStandardNewMacro(vtkResponseChoice);

vtkResponseChoice::vtkResponseChoice() = default;

vtkResponseChoice::~vtkResponseChoice() = default;

std::string vtkResponseChoice::CheckSettings() const
{
  std::ostringstream text;
  if (!(this->Tolerance > 0.0))
  {
    text << "Tolerance must be above 0, but is " << this->Tolerance;
  }
  else if (!(this->Share > 0.0 && this->Share <= 1.0))
  {
    text << "Share must be above 0 and at most 1, but is " << this->Share;
  }
  else if (!(this->Deflection >= 0.0 && std::isfinite(this->Deflection)))
  {
    text << "Deflection must be finite and not negative (mm), but is " << this->Deflection;
  }
  else if (this->MaximumNumberOfLaws < 1 || this->MaximumNumberOfLaws > 16)
  {
    text << "MaximumNumberOfLaws must lie between 1 and 16, but is " << this->MaximumNumberOfLaws;
  }
  return text.str();
}

int vtkResponseChoice::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* body = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (!body || body->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  std::string fault = this->CheckSettings();
  palpate::ResponseArrays arrays;
  std::string missing;
  if (fault.empty() && !palpate::viewResponse(body, this->ResponseName, arrays, missing))
  {
    fault = "No response '" + this->ResponseName + "' on the body: " + missing;
  }
  palpate::ChoiceEvidence evidence;
  fault = fault.empty() ? readEvidence(body, this->ResponseName, evidence) : fault;
  double depth = this->Deflection;
  fault = fault.empty() ? chooseDepth(body, arrays, depth) : fault;
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return 0;
  }

  const palpate::ChoiceSettings settings{ this->Tolerance, this->Share, depth,
    this->MaximumNumberOfLaws };
  const palpate::FilterThreads threads;
  const palpate::ResponseChoice choice = palpate::chooseResponse(arrays, evidence, settings);
  this->NumbersPerPointBefore = arrays.basis ? arrays.laws : 2 * arrays.samples;
  this->Verdict = static_cast<int>(choice.need);
  this->Reason = palpate::choiceReason(choice, settings, this->NumbersPerPointBefore);
  this->NumbersPerPoint = choice.numbersPerPoint;
  this->LargestError = choice.largestError;
  this->KeptShare = choice.keptShare;
  this->ShapelessShare = choice.shapelessShare;
  this->SpringLoss = choice.springLoss;
  this->BeyondValidityShare = choice.beyondShare;

  palpate::copyWithOwnFields(body, output);
  if (choice.need != ResponseNeed::PerVertex)
  {
    replaceCurves(output, this->ResponseName, choice);
  }
  palpate::addText(output, this->ResponseName + "Choice", this->Reason);
  return 1;
}

void vtkResponseChoice::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "Share: " << this->Share << "\n";
  os << indent << "Deflection: " << this->Deflection << " mm\n";
  os << indent << "MaximumNumberOfLaws: " << this->MaximumNumberOfLaws << "\n";
  os << indent << "ResponseName: " << this->ResponseName << "\n";
  os << indent << "Verdict: " << this->Verdict << "\n";
  os << indent << "Reason: " << this->Reason << "\n";
}
