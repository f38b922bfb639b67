// SPDX-License-Identifier: BSD-3-Clause
#include "vtkResponseChoice.h"

#include "Response/BodyChoice.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

namespace
{
using palpate::ResponseArray;
using palpate::ResponseNeed;

static_assert(static_cast<int>(ResponseNeed::PointForce) == vtkResponseChoice::PointForce &&
  static_cast<int>(ResponseNeed::PerVertex) == vtkResponseChoice::PerVertex);

} // namespace

vtkStandardNewMacro(vtkResponseChoice);

vtkResponseChoice::vtkResponseChoice() = default;

vtkResponseChoice::~vtkResponseChoice() = default;

int vtkResponseChoice::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* body = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (!body || body->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  palpate::AttachedChoice attached;
  const std::string fault = palpate::attachChoice(body, this->ResponseName,
    { this->Tolerance, this->Share, this->Deflection, this->MaximumNumberOfLaws }, output,
    attached);
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return 0;
  }
  const palpate::ResponseChoice& choice = attached.choice;
  this->NumbersPerPointBefore = attached.numbersPerPointBefore;
  this->Verdict = static_cast<int>(choice.need);
  this->Reason = attached.reason;
  this->NumbersPerPoint = choice.numbersPerPoint;
  this->LargestError = choice.largestError;
  this->KeptShare = choice.keptShare;
  this->ShapelessShare = choice.shapelessShare;
  this->SpringLoss = choice.springLoss;
  this->BeyondValidityShare = choice.beyondShare;
  this->RelaxationElements = attached.relaxation.elements;
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
