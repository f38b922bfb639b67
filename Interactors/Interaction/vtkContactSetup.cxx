// SPDX-License-Identifier: BSD-3-Clause
#include "vtkContactSetup.h"

#include "Haptics/Devices/RecordedSetup.h"
#include "Interaction/Session/SetupState.h"
#include "vtkContactScene.h"
#include "vtkContactSettings.h"
#include "vtkContactTool.h"
#include "vtkHapticSession.h"

#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkContactSetup);

vtkContactSetup::vtkContactSetup()
  : Kept(std::make_unique<State>())
{
}

vtkContactSetup::~vtkContactSetup() = default;

void vtkContactSetup::SetBody(vtkPolyData* body)
{
  this->Kept->body = body;
  this->Kept->copy = nullptr;
  this->Kept->made.kernels = {};
  this->Kept->computed = nullptr;
  this->Modified();
}

vtkPolyData* vtkContactSetup::GetBody()
{
  return this->Kept->body;
}

void vtkContactSetup::AddTool(vtkContactTool* tool)
{
  this->Kept->tools.emplace_back(tool);
  this->Modified();
}

void vtkContactSetup::RemoveAllTools()
{
  this->Kept->tools.clear();
  this->ChosenTool = 0;
  this->Modified();
}

int vtkContactSetup::GetNumberOfTools()
{
  return static_cast<int>(this->Kept->tools.size());
}

vtkContactTool* vtkContactSetup::GetTool(int tool)
{
  return tool >= 0 && tool < this->GetNumberOfTools()
    ? this->Kept->tools[static_cast<std::size_t>(tool)].Get()
    : nullptr;
}

std::string vtkContactSetup::GetResponseName(int tool)
{
  return tool == 0 ? "Response" : "Response" + std::to_string(tool + 1);
}

void vtkContactSetup::AddLayer(
  double thickness, double youngsModulus, double poissonRatio, bool slips)
{
  this->Kept->added.push_back({ thickness, youngsModulus, poissonRatio, slips });
  this->Modified();
}

void vtkContactSetup::ClearLayers()
{
  this->Kept->added.clear();
  this->Modified();
}

int vtkContactSetup::GetNumberOfAddedLayers()
{
  return static_cast<int>(this->Kept->added.size());
}

void vtkContactSetup::SetChosenTool(int tool)
{
  this->ChosenTool = std::clamp(tool, 0, std::max(this->GetNumberOfTools() - 1, 0));
}

bool vtkContactSetup::HasModel(int model)
{
  if (!this->Kept->body)
  {
    return false;
  }
  vtkPointData* data = this->Kept->body->GetPointData();
  switch (model)
  {
    case HalfSpace:
      return this->Model != Stored;
    case Layer:
      return this->Model != Stored &&
        (this->LayerThickness > 0.0 ||
          data->HasArray(this->Kept->added.empty() ? palpate::SetupArrays::Thickness
                                                   : palpate::SetupArrays::First));
    case Series:
      return this->Model != Stored && data->HasArray(palpate::SetupArrays::Compliance);
    case Stored:
      return data->HasArray("ResponseRange");
    default:
      return false;
  }
}

vtkPolyData* vtkContactSetup::GetOutput()
{
  return this->Kept->output;
}

vtkContactTool* vtkContactSetup::GetOutputTool(int tool)
{
  const auto& tools = this->Kept->made.tools;
  return tool >= 0 && tool < static_cast<int>(tools.size())
    ? tools[static_cast<std::size_t>(tool)].Get()
    : nullptr;
}

std::string vtkContactSetup::GetChoice(int tool)
{
  const auto& choices = this->Kept->made.choices;
  return tool >= 0 && tool < static_cast<int>(choices.size())
    ? choices[static_cast<std::size_t>(tool)]
    : std::string();
}

double vtkContactSetup::GetLargestForce()
{
  double largest = 0.0;
  for (const auto& [response, peaks] : this->Kept->made.kernels.peaks)
  {
    largest = std::max(largest, peaks ? peaks->first : 0.0);
  }
  return largest;
}

void vtkContactSetup::SetSettings(vtkContactSettings* settings)
{
  // Modified() is not called, because responses do not depend on the settings.
  this->Settings = settings;
}

vtkContactSettings* vtkContactSetup::GetSettings()
{
  return this->Settings;
}

bool vtkContactSetup::ApplyTo(vtkHapticSession* session)
{
  if (!session || !this->Kept->output)
  {
    vtkErrorMacro(<< "A session and responses are required: call Update.");
    return false;
  }
  // The body is set again for a stopped session, because the session would otherwise make the
  // kernels at its start.
  if (session->GetBody() != this->Kept->output || session->GetState() == vtkHapticSession::Stopped)
  {
    session->SetBody(this->Kept->output, this->Kept->made.kernels);
  }
  session->SetResponseName(this->GetResponseName(this->ChosenTool));
  if (this->Settings)
  {
    session->SetSettings(this->Settings);
  }
  session->GetSettings()->SetPoissonRatio(this->Kept->made.poissonRatio);
  const palpate::ResponseRequest& of = this->Kept->made.of;
  session->SetMaterial(
    of.stored ? std::string() : palpate::materialInWords(of.youngsModulus, of.poissonRatio));
  session->GetSafety()->ClearFitResponses();
  for (int i = 0; i < this->GetNumberOfTools(); ++i)
  {
    session->GetSafety()->AddFitResponse(this->GetResponseName(i));
  }
  return session->ApplyChanges();
}

void vtkContactSetup::ShowIn(vtkContactScene* scene)
{
  vtkContactTool* tool = this->GetOutputTool(this->ChosenTool);
  if (!scene || !this->Kept->output || !tool)
  {
    vtkErrorMacro(<< "A scene and responses are required: call Update.");
    return;
  }
  scene->SetBody(this->Kept->output);
  scene->SetTool(tool);
  scene->SetPoissonRatio(this->Kept->made.poissonRatio);
}

vtkMTimeType vtkContactSetup::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (const auto& tool : this->Kept->tools)
  {
    time = std::max(time, tool->GetMTime());
  }
  return time;
}

void vtkContactSetup::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Body: " << this->Kept->body.Get() << "\n";
  os << indent << "NumberOfTools: " << this->GetNumberOfTools() << "\n";
  os << indent << "ChosenTool: " << this->ChosenTool << "\n";
  os << indent << "YoungsModulus: " << this->YoungsModulus << " MPa\n";
  os << indent << "PoissonRatio: " << this->PoissonRatio << "\n";
  os << indent << "MaximumDeflection: " << this->MaximumDeflection << " mm\n";
  os << indent << "Model: " << this->Model << "\n";
  os << indent << "LayerThickness: " << this->LayerThickness << " mm\n";
  os << indent << "AddedLayers: " << this->Kept->added.size() << "\n";
  os << indent << "LayerBase: " << this->LayerBase << "\n";
  os << indent << "BaseYoungsModulus: " << this->BaseYoungsModulus << " MPa\n";
  os << indent << "BasePoissonRatio: " << this->BasePoissonRatio << "\n";
  os << indent << "BaseSlips: " << this->BaseSlips << "\n";
  os << indent << "ComplianceModulus: " << this->ComplianceModulus << " MPa\n";
  os << indent << "CurvatureCorrection: " << this->CurvatureCorrection << "\n";
  os << indent << "EdgeCorrection: " << this->EdgeCorrection << "\n";
  os << indent << "MaximumTilt: " << this->MaximumTilt << " degrees\n";
  os << indent << "Coupling: " << this->Coupling << "\n";
  os << indent << "Relaxations: " << this->Relaxations.count() << "\n";
  os << indent << "ComplianceRelaxes: " << this->ComplianceRelaxes << "\n";
  os << indent << "StrainModel: " << this->StrainModel << "\n";
  os << indent << "StrainExponent: " << this->StrainExponent << "\n";
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
  os << indent << "AutomaticTerms: " << this->AutomaticTerms << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "ChoiceDeflection: " << this->ChoiceDeflection << " mm\n";
  os << indent << "Settings: " << this->Settings.Get() << "\n";
  os << indent << "Error: " << this->Error << "\n";
}
