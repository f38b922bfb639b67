// SPDX-License-Identifier: BSD-3-Clause
#include "vtkContactDeflection.h"

#include "Response/Pieces/ChosenTip.h"
#include "Response/BodyField.h"
#include "Response/Pieces/OwnPiece.h"
#include "Response/Pieces/Ranks.h"
#include "Mechanics/ReducedModulus.h"
#include "Response/ResponseTool.h"
#include "Response/Touch/TipTimes.h"
#include "vtkContactTool.h"

#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <sstream>

vtkStandardNewMacro(vtkContactDeflection);

vtkContactDeflection::vtkContactDeflection()
  : Controller(vtkMultiProcessController::GetGlobalController())
  , Field(std::make_unique<palpate::BodyField>())
{
  this->SetNumberOfInputPorts(2);
}

vtkContactDeflection::~vtkContactDeflection() = default;

void vtkContactDeflection::SetController(vtkMultiProcessController* controller)
{
  if (this->Controller != controller)
  {
    this->Controller = controller;
    // The old field belongs to pieces of the old controller.
    this->Field = std::make_unique<palpate::BodyField>();
    this->Modified();
  }
}

vtkMultiProcessController* vtkContactDeflection::GetController()
{
  return this->Controller;
}

int vtkContactDeflection::FillInputPortInformation(int, vtkInformation* info)
{
  // Accepts any data, because RequestData reports a wrong type together with the remedy.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

std::string vtkContactDeflection::FindTool(vtkPolyData* body, vtkSmartPointer<vtkContactTool>& tool)
{
  std::string fault = palpate::checkBody(body, this->ResponseName);
  if (!fault.empty())
  {
    return "Wrong body: " + fault;
  }
  if (!palpate::isPoissonsRatio(this->PoissonRatio))
  {
    std::ostringstream text;
    text << "Poisson's Ratio must lie between 0 and 0.5, but is " << this->PoissonRatio;
    return text.str();
  }
  tool = palpate::findTool(this->Tool, body, this->ResponseName, fault);
  return fault.empty() && !tool->GetKernel() ? "The Tool is invalid" : fault;
}

int vtkContactDeflection::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  palpate::passTimes(inputVector, outputVector->GetInformationObject(0));
  return 1;
}

int vtkContactDeflection::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const palpate::Ranks ranks(this->Controller);
  std::string fault = palpate::checkType(inputVector[0]->GetInformationObject(0), "body");
  if (fault.empty())
  {
    fault = palpate::checkType(inputVector[1]->GetInformationObject(0), "tips");
  }
  const auto body = palpate::ownPiece(vtkPolyData::GetData(inputVector[0]), ranks);
  vtkPolyData* tips = vtkPolyData::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  palpate::passDataTime(body, tips, output);
  const bool hasPiece = body->GetNumberOfPoints() > 0;
  vtkSmartPointer<vtkContactTool> tool;
  if (fault.empty() && hasPiece)
  {
    fault = this->FindTool(body, tool);
  }
  fault = ranks.firstFault(fault);
  palpate::ChosenTip tip;
  if (fault.empty() && ranks.any(hasPiece))
  {
    fault = palpate::chooseTip(ranks, tips, this->TipIndex, tip);
  }
  const palpate::FieldContact& contact = tip.contact;
  if (fault.empty())
  {
    const bool isWrong = contact.cell >= 0 && tip.rank == ranks.own() &&
      !palpate::isTriangle(body, static_cast<vtkIdType>(contact.cell));
    fault = ranks.firstFault(isWrong ? "ContactCell " + std::to_string(contact.cell) +
          " is not a triangle of the body: were the tips probed on another body?"
                                     : std::string());
  }
  vtkNew<vtkFloatArray> displacement;
  if (fault.empty())
  {
    fault = this->Field->displace(ranks, body, contact, tip.rank,
      { tool ? tool->GetKernel() : nullptr, this->ResponseName,
        { this->PoissonRatio, this->MaximumDistance } },
      displacement);
  }
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << (fault.back() == '?' ? "" : "."));
    return 0;
  }
  for (const std::string& warning : this->Field->warnings())
  {
    vtkWarningMacro(<< warning << ".");
  }
  if (hasPiece)
  {
    output->ShallowCopy(body);
    palpate::passDataTime(body, tips, output);
    output->GetPointData()->AddArray(displacement);
  }
  return 1;
}

void vtkContactDeflection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller.Get() << "\n";
  os << indent << "TipIndex: " << this->TipIndex << "\n";
  os << indent << "PoissonRatio: " << this->PoissonRatio << "\n";
  os << indent << "MaximumDistance: " << this->MaximumDistance << " mm\n";
}
