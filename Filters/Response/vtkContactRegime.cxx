// SPDX-License-Identifier: BSD-3-Clause
#include "vtkContactRegime.h"

#include "Response/BodyRegime.h"
#include "Response/Pieces/OwnPiece.h"
#include "vtkContactTool.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkContactRegime);

vtkContactRegime::vtkContactRegime()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
}

vtkContactRegime::~vtkContactRegime() = default;

void vtkContactRegime::SetController(vtkMultiProcessController* controller)
{
  if (this->Controller != controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkContactRegime::GetController()
{
  return this->Controller;
}

int vtkContactRegime::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const palpate::Ranks ranks(this->Controller);
  const auto body = palpate::ownPiece(vtkPolyData::GetData(inputVector[0]), ranks);
  const palpate::LawRequest request{ this->Tool, this->ResponseName, this->Deflection,
    palpate::layeredMaterial(
      { this->YoungsModulus, this->PoissonRatio, this->LayerThickness,
        this->LayerBase == 1 ? palpate::LayerBase::Slip : palpate::LayerBase::Bonded,
        this->ComplianceExcludesLayer },
      this->AddedLayers, this->LayerBase == 2, this->BaseYoungsModulus, this->BasePoissonRatio),
    palpate::arraysToProcess(
      this, [this, &body](int index) { return this->GetInputArrayToProcess(index, body); }) };
  const std::string fault =
    palpate::attachRegime(ranks, body, request, vtkPolyData::GetData(outputVector));
  return this->Report(fault);
}

void vtkContactRegime::AddLayer(
  double thickness, double youngsModulus, double poissonRatio, bool slips)
{
  this->AddedLayers.push_back({ thickness, youngsModulus, poissonRatio, slips ? 1.0 : 0.0 });
  this->Modified();
}

void vtkContactRegime::ClearLayers()
{
  if (!this->AddedLayers.empty())
  {
    this->AddedLayers.clear();
    this->Modified();
  }
}

int vtkContactRegime::GetNumberOfAddedLayers()
{
  return static_cast<int>(this->AddedLayers.size());
}

void vtkContactRegime::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller.Get() << "\n";
  os << indent << "Deflection: " << this->Deflection << " mm\n";
  os << indent << "YoungsModulus: " << this->YoungsModulus << " MPa\n";
  os << indent << "PoissonRatio: " << this->PoissonRatio << "\n";
  os << indent << "LayerThickness: " << this->LayerThickness << " mm\n";
  os << indent << "LayerBase: " << this->LayerBase << "\n";
  os << indent << "ComplianceExcludesLayer: " << this->ComplianceExcludesLayer << "\n";
  os << indent << "AddedLayers: " << this->AddedLayers.size() << "\n";
  os << indent << "BaseYoungsModulus: " << this->BaseYoungsModulus << " MPa\n";
  os << indent << "BasePoissonRatio: " << this->BasePoissonRatio << "\n";
}
