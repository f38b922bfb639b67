// SPDX-License-Identifier: BSD-3-Clause
#include "vtkReducedContactResponse.h"

#include "Response/BodyConversion.h"
#include "Response/FilterThreads.h"
#include "Response/ReplacedCurves.h"
#include "Contact/Reduction/ResponseReduction.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <sstream>
#include <vector>

namespace
{
using palpate::ReducedForm;
using palpate::ReducedResponse;
using palpate::ResponseArray;

static_assert(static_cast<int>(ReducedForm::OneLaw) == vtkReducedContactResponse::OneLaw &&
  static_cast<int>(ReducedForm::Unchanged) == vtkReducedContactResponse::Unchanged);

/// Replaces the curves by those of the reduced form.
void replaceCurves(vtkPolyData* body, const std::string& name, const ReducedResponse& reduced)
{
  if (reduced.form == ReducedForm::Unchanged)
  {
    return;
  }
  palpate::removeCurves(body, name);
  if (reduced.laws > 0)
  {
    palpate::addFloats(body, name, ResponseArray::Basis, 2 * reduced.samples, reduced.basis);
    palpate::addFloats(body, name, ResponseArray::Coefficient, reduced.laws, reduced.coefficient);
    return;
  }
  palpate::addFloats(body, name, ResponseArray::Force, reduced.samples, reduced.force);
  palpate::addFloats(body, name, ResponseArray::Stiffness, reduced.samples, reduced.stiffness);
  vtkNew<vtkIntArray> samples;
  samples->SetName(palpate::arrayName(name, ResponseArray::Samples).c_str());
  samples->InsertNextValue(reduced.samples);
  body->GetFieldData()->AddArray(samples);
}

std::string describe(const ReducedResponse& reduced, int before)
{
  std::ostringstream text;
  text.precision(2);
  switch (reduced.form)
  {
    case ReducedForm::OneLaw:
      text << "one law for the whole body";
      break;
    case ReducedForm::Scale:
      text << "one law, times a number per point";
      break;
    case ReducedForm::Basis:
      text << reduced.laws << " laws, combined at each point";
      break;
    case ReducedForm::Samples:
      text << "a curve per point in " << reduced.samples << " samples";
      break;
    case ReducedForm::Unchanged:
      return "no form is smaller than the " + std::to_string(before) +
        " numbers per point of the input";
  }
  text << ": " << reduced.numbersPerPoint << " instead of " << before
       << " numbers per point; the force is off by " << 100.0 * reduced.largestError
       << " % at most (point " << reduced.worstPoint << "), its slope by "
       << 100.0 * reduced.largestSlopeError << " %";
  return text.str();
}
} // namespace

vtkStandardNewMacro(vtkReducedContactResponse);

vtkReducedContactResponse::vtkReducedContactResponse() = default;

vtkReducedContactResponse::~vtkReducedContactResponse() = default;

int vtkReducedContactResponse::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* body = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (!body || body->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  if (!(this->Tolerance > 0.0))
  {
    vtkErrorMacro(<< "Tolerance must be above 0, but is " << this->Tolerance << ".");
    return 0;
  }
  if (this->MaximumNumberOfLaws < 1 || this->MaximumNumberOfLaws > 16)
  {
    vtkErrorMacro(<< "Maximum Number Of Laws must lie between 1 and 16, but is "
                  << this->MaximumNumberOfLaws << ".");
    return 0;
  }
  palpate::ResponseArrays arrays;
  std::string error;
  if (!palpate::viewResponse(body, this->ResponseName, arrays, error))
  {
    vtkErrorMacro(<< "No response '" << this->ResponseName << "' on the body: " << error << ".");
    return 0;
  }

  const palpate::FilterThreads threads;
  const ReducedResponse reduced =
    palpate::reduceResponse(arrays, { this->Tolerance, this->MaximumNumberOfLaws });
  this->Form = static_cast<int>(reduced.form);
  this->NumbersPerPointBefore = arrays.basis ? arrays.laws : 2 * arrays.samples;
  this->NumbersPerPoint = reduced.numbersPerPoint;
  this->LargestError = reduced.largestError;
  this->LargestStiffnessError = reduced.largestSlopeError;
  this->WorstPoint =
    reduced.form == ReducedForm::Unchanged ? -1 : static_cast<vtkIdType>(reduced.worstPoint);
  this->Report = describe(reduced, this->NumbersPerPointBefore);

  palpate::copyWithOwnFields(body, output);
  replaceCurves(output, this->ResponseName, reduced);
  palpate::addText(output, this->ResponseName, ResponseArray::Reduction, this->Report);
  vtkNew<vtkDoubleArray> largest;
  largest->SetName(palpate::arrayName(this->ResponseName, ResponseArray::ReductionError).c_str());
  largest->InsertNextValue(this->LargestError);
  output->GetFieldData()->AddArray(largest);
  return 1;
}

void vtkReducedContactResponse::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumNumberOfLaws: " << this->MaximumNumberOfLaws << "\n";
  os << indent << "ResponseName: " << this->ResponseName << "\n";
  os << indent << "Report: " << this->Report << "\n";
}
