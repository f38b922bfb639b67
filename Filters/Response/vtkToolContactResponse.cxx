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

#include <algorithm>

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

void vtkToolContactResponse::SetTool(vtkContactTool* tool)
{
  if (this->Tool != tool)
  {
    this->Tool = tool;
    this->Modified();
  }
}

vtkContactTool* vtkToolContactResponse::GetTool()
{
  return this->Tool;
}

vtkMTimeType vtkToolContactResponse::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Tool ? std::max(own, this->Tool->GetMTime()) : own;
}

int vtkToolContactResponse::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const palpate::Ranks ranks(this->Controller);
  const auto body = palpate::ownPiece(vtkPolyData::GetData(inputVector[0]), ranks);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  palpate::RelaxationRequest relaxation;
  std::string fault = this->Relaxations.fillSeries(relaxation.series);
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return 0;
  }
  const auto find = [this, &body](int index) { return this->GetInputArrayToProcess(index, body); };
  relaxation.strength = palpate::arrayToProcess(this, palpate::RelaxationArrayIndex, find);
  relaxation.complianceRelaxes = this->ComplianceRelaxes;
  const palpate::LawRequest request{ this->Tool, this->ResponseName, this->MaximumDeflection,
    palpate::layeredMaterial(
      { this->YoungsModulus, this->PoissonRatio, this->LayerThickness,
        this->LayerBase == 1 ? palpate::LayerBase::Slip : palpate::LayerBase::Bonded,
        this->ComplianceExcludesLayer },
      this->AddedLayers, this->LayerBase == 2, this->BaseYoungsModulus, this->BasePoissonRatio),
    palpate::arraysToProcess(this, find), this->NumberOfSamples,
    { this->CurvatureCorrection,
      palpate::strainLawOf(this->StrainModel, this->OgdenExponent, this->DemirayExponent),
      this->ErrorTolerance, this->StoreError, this->AutomaticTerms, this->TermTolerance,
      this->EdgeCorrection, this->MaximumTilt },
    nullptr, relaxation, this->Coupling,
    palpate::arrayToProcess(this, palpate::PressedArrayIndex, find), this->WholeBody };
  std::string warning;
  fault = palpate::attachResponse(
    ranks, body, request, palpate::FilterStage{ this, 0.0, 1.0 }, output, warning);
  this->TermReason = palpate::termsReason(output, this->ResponseName);
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return 0;
  }
  if (!warning.empty())
  {
    vtkWarningMacro(<< warning << ".");
  }
  return 1;
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

void vtkToolContactResponse::AddRelaxation(double strength, double seconds)
{
  this->Relaxations.add(strength, seconds);
  this->Modified();
}

void vtkToolContactResponse::ClearRelaxations()
{
  if (this->Relaxations.clear())
  {
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
  os << indent << "Tool: " << this->Tool.Get() << "\n";
  os << indent << "YoungsModulus: " << this->YoungsModulus << " MPa\n";
  os << indent << "PoissonRatio: " << this->PoissonRatio << "\n";
  os << indent << "LayerThickness: " << this->LayerThickness << " mm\n";
  os << indent << "LayerBase: " << this->LayerBase << "\n";
  os << indent << "ComplianceExcludesLayer: " << this->ComplianceExcludesLayer << "\n";
  os << indent << "WholeBody: " << this->WholeBody << "\n";
  os << indent << "AddedLayers: " << this->AddedLayers.size() << "\n";
  os << indent << "BaseYoungsModulus: " << this->BaseYoungsModulus << " MPa\n";
  os << indent << "BasePoissonRatio: " << this->BasePoissonRatio << "\n";
  os << indent << "CurvatureCorrection: " << this->CurvatureCorrection << "\n";
  os << indent << "EdgeCorrection: " << this->EdgeCorrection << "\n";
  os << indent << "MaximumTilt: " << this->MaximumTilt << " degrees\n";
  os << indent << "Coupling: " << this->Coupling << "\n";
  os << indent << "Relaxations: " << this->Relaxations.count() << "\n";
  os << indent << "ComplianceRelaxes: " << this->ComplianceRelaxes << "\n";
  os << indent << "StrainModel: " << this->StrainModel << "\n";
  os << indent << "OgdenExponent: " << this->OgdenExponent << "\n";
  os << indent << "DemirayExponent: " << this->DemirayExponent << "\n";
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
  os << indent << "StoreError: " << this->StoreError << "\n";
  os << indent << "AutomaticTerms: " << this->AutomaticTerms << "\n";
  os << indent << "TermTolerance: " << this->TermTolerance << "\n";
  os << indent << "MaximumDeflection: " << this->MaximumDeflection << " mm\n";
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "ResponseName: " << this->ResponseName << "\n";
}
