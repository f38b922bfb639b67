// SPDX-License-Identifier: BSD-3-Clause
#include "vtkToolContactResponse.h"

#include "Response/BodyLaws.h"
#include "Response/Curves/AutomaticTerms.h"
#include "Response/Curves/PressedPoints.h"
#include "Response/FilterStage.h"
#include "Response/Pieces/OwnPiece.h"
#include "vtkContactTool.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkToolContactResponse);

vtkToolContactResponse::vtkToolContactResponse()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
}

vtkToolContactResponse::~vtkToolContactResponse() = default;

void vtkToolContactResponse::SetController(vtkMultiProcessController* controller)
{
  if (this->Controller != controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkToolContactResponse::GetController()
{
  return this->Controller;
}

int vtkToolContactResponse::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const palpate::Ranks ranks(this->Controller);
  const auto body = palpate::ownPiece(vtkPolyData::GetData(inputVector[0]), ranks);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  palpate::LawRequest request;
  std::string fault = this->FillRequest(request);
  if (!fault.empty())
  {
    return this->Report(fault);
  }
  const auto find = [this, &body](int index) { return this->GetInputArrayToProcess(index, body); };
  request.material = palpate::layeredMaterial(
    { this->YoungsModulus, this->PoissonRatio, this->LayerThickness,
      this->LayerBase == 1 ? palpate::LayerBase::Slip : palpate::LayerBase::Bonded,
      this->ComplianceExcludesLayer },
    this->AddedLayers, this->LayerBase == 2, this->BaseYoungsModulus, this->BasePoissonRatio);
  request.arrays = palpate::arraysToProcess(this, find);
  request.terms.curvature = this->CurvatureCorrection;
  request.relaxation.strength = palpate::arrayToProcess(this, palpate::RelaxationArrayIndex, find);
  request.relaxation.complianceRelaxes = this->ComplianceRelaxes;
  request.couples = this->Coupling;
  request.pressed = palpate::arrayToProcess(this, palpate::PressedArrayIndex, find);
  request.wholeBody = this->WholeBody;
  std::string warning;
  fault = palpate::attachResponse(
    ranks, body, request, palpate::FilterStage{ this, 0.0, 1.0 }, output, warning);
  this->TermReason = palpate::termsReason(output, this->ResponseName);
  if (fault.empty() && !warning.empty())
  {
    vtkWarningMacro(<< warning << ".");
  }
  return this->Report(fault);
}

void vtkToolContactResponse::AddLayer(
  double thickness, double youngsModulus, double poissonRatio, bool slips)
{
  this->AddedLayers.push_back({ thickness, youngsModulus, poissonRatio, slips ? 1.0 : 0.0 });
  this->Modified();
}

void vtkToolContactResponse::ClearLayers()
{
  if (!this->AddedLayers.empty())
  {
    this->AddedLayers.clear();
    this->Modified();
  }
}

int vtkToolContactResponse::GetNumberOfAddedLayers()
{
  return static_cast<int>(this->AddedLayers.size());
}

void vtkToolContactResponse::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller.Get() << "\n";
  os << indent << "LayerBase: " << this->LayerBase << "\n";
  os << indent << "ComplianceExcludesLayer: " << this->ComplianceExcludesLayer << "\n";
  os << indent << "WholeBody: " << this->WholeBody << "\n";
  os << indent << "AddedLayers: " << this->AddedLayers.size() << "\n";
  os << indent << "BaseYoungsModulus: " << this->BaseYoungsModulus << " MPa\n";
  os << indent << "BasePoissonRatio: " << this->BasePoissonRatio << "\n";
  os << indent << "CurvatureCorrection: " << this->CurvatureCorrection << "\n";
  os << indent << "Coupling: " << this->Coupling << "\n";
  os << indent << "ComplianceRelaxes: " << this->ComplianceRelaxes << "\n";
}
