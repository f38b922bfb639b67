// SPDX-License-Identifier: BSD-3-Clause
// Makes the requests of a vtkContactSetup, and takes over the results.
#include "vtkContactSetup.h"

#include "Interaction/Session/ModulusChange.h"
#include "Interaction/Session/SetupState.h"
#include "Mechanics/Files/NumberText.h"
#include "vtkToolContactResponse.h"

#include "vtkCommand.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>

namespace
{
using Tool = vtkSmartPointer<vtkContactTool>;

/// Returns a copy of a tool, for use on another thread.
Tool copyOf(vtkContactTool* tool)
{
  auto copy = Tool::New();
  copy->SetShape(tool->GetShape());
  copy->SetRadius(tool->GetRadius());
  copy->SetHalfAngle(tool->GetHalfAngle());
  copy->SetEdgeRadius(tool->GetEdgeRadius());
  copy->SetExponent(tool->GetExponent());
  copy->SetCoefficient(tool->GetCoefficient());
  if (vtkPoints* profile = tool->GetProfilePoints())
  {
    vtkNew<vtkPoints> points;
    points->DeepCopy(profile);
    copy->SetProfile(points);
  }
  return copy;
}

/// Returns a text that is equal for equal tools. The text of a profile also contains its
/// modification time.
std::string keyOf(vtkContactTool* tool)
{
  const bool isText = tool->HasSize() || tool->GetShape() == vtkContactTool::PowerLaw;
  return tool->GetSpecification() + (isText ? "" : ' ' + std::to_string(tool->GetMTime()));
}

/// Returns a shallow copy of `body`, the displayed body, with the arrays that another thread has
/// added to its own copy of the body.
vtkSmartPointer<vtkPolyData> withAddedArrays(vtkPolyData* body, const palpate::MadeResponses& made)
{
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->ShallowCopy(body);
  const auto addNew = [](vtkFieldData* to, vtkFieldData* from, vtkFieldData* known)
  {
    for (int i = 0; i < from->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = from->GetAbstractArray(i);
      if (array->GetName() && known->GetAbstractArray(array->GetName()) != array)
      {
        to->AddArray(array);
      }
    }
  };
  addNew(output->GetPointData(), made.body->GetPointData(), made.from->GetPointData());
  addNew(output->GetFieldData(), made.body->GetFieldData(), made.from->GetFieldData());
  return output;
}
} // namespace

bool vtkContactSetup::MakeRequest(palpate::ResponseRequest& request)
{
  State& kept = *this->Kept;
  this->Error = !kept.body ? "A body is required: call SetBody."
    : kept.tools.empty()   ? "A tool is required: call AddTool."
    : !this->HasModel(this->Model)
    ? "The body does not have the data for model " + std::to_string(this->Model) + "."
    : "";
  if (!this->Error.empty())
  {
    vtkErrorMacro(<< this->Error);
    return false;
  }
  if (!kept.copy)
  {
    kept.copy = vtkSmartPointer<vtkPolyData>::New();
    kept.copy->DeepCopy(kept.body);
  }
  request.body = kept.copy;
  for (int i = 0; i < this->GetNumberOfTools(); ++i)
  {
    request.tools.push_back(copyOf(this->GetTool(i)));
    request.toolKeys.push_back(keyOf(this->GetTool(i)));
    request.names.push_back(this->GetResponseName(i));
  }
  request.stored = this->Model == Stored;
  request.youngsModulus = this->YoungsModulus;
  request.poissonRatio = this->PoissonRatio;
  request.maximumDeflection = this->MaximumDeflection;
  request.terms = { this->CurvatureCorrection,
    { static_cast<palpate::StrainModel>(this->StrainModel), this->StrainExponent },
    this->ErrorTolerance, true, this->AutomaticTerms,
    this->Tolerance > 0.0 ? this->Tolerance : palpate::LawTerms().changeTolerance,
    this->EdgeCorrection, this->MaximumTilt };
  this->Error = this->Relaxations.effectiveBranches().fillSeries(request.relaxation.series);
  if (!this->Error.empty())
  {
    vtkErrorMacro(<< this->Error << ".");
    return false;
  }
  request.relaxation.complianceRelaxes = this->ComplianceRelaxes;
  request.coupling = this->Coupling;
  request.tolerance = this->Tolerance;
  request.choiceDeflection = this->ChoiceDeflection;
  if (this->Model == Layer)
  {
    request.layerThickness = this->LayerThickness;
    const char* first =
      kept.added.empty() ? palpate::SetupArrays::Thickness : palpate::SetupArrays::First;
    request.thicknessArray = this->LayerThickness > 0.0 ? "" : first;
    request.deeper = kept.added;
    if (!kept.added.empty() && kept.added.front().thickness == 0.0)
    {
      request.secondArray = palpate::SetupArrays::Second;
    }
    request.base = this->LayerBase == vtkToolContactResponse::Slip ? palpate::LayerBase::Slip
                                                                   : palpate::LayerBase::Bonded;
    if (this->LayerBase == vtkToolContactResponse::ElasticBase)
    {
      request.halfSpace = palpate::StackLayer{ 1.0, this->BaseYoungsModulus, this->BasePoissonRatio,
        this->BaseSlips };
    }
  }
  if (this->Model == Series)
  {
    request.complianceArray = palpate::SetupArrays::Compliance;
    request.complianceFactor =
      this->ComplianceModulus > 0.0 ? this->ComplianceModulus / this->YoungsModulus : 1.0;
  }
  const auto& known = kept.made.kernels.read;
  request.surface = known.empty() ? nullptr : known.begin()->second;
  request.known = kept.computed;
  kept.asked = { this->YoungsModulus, this->PoissonRatio, this->Model, this->Relaxations, {} };
  for (const auto& tool : kept.tools)
  {
    kept.asked.sizes.push_back(tool->HasSize() ? tool->GetSize() : 0.0);
  }
  kept.requested = this->GetMTime();
  return true;
}

bool vtkContactSetup::TakeOver(palpate::MadeResponses&& made)
{
  this->Error = made.error.empty() ? "" : made.error + ".";
  if (!this->Error.empty())
  {
    vtkErrorMacro(<< this->Error);
    return false;
  }
  State& kept = *this->Kept;
  if (!made.warning.empty() && made.warning != kept.made.warning)
  {
    vtkWarningMacro(<< made.warning << ".");
  }
  const bool isScaled =
    kept.computed && (made.isPreliminary || palpate::isModulusChange(kept.computed->of, made.of));
  if (!isScaled)
  {
    kept.computed = std::make_shared<const palpate::MadeResponses>(made);
  }
  kept.made = std::move(made);
  kept.output = withAddedArrays(kept.body, kept.made);
  kept.made.body = nullptr;
  // Cancel() restores the settings of the last complete result.
  kept.shown = kept.made.isPreliminary ? kept.shown : kept.asked;
  return true;
}

bool vtkContactSetup::Update()
{
  this->Kept->background.cancel();
  palpate::ResponseRequest request;
  const auto report = [this](double done)
  {
    this->InvokeEvent(vtkCommand::ProgressEvent, &done);
    return true;
  };
  if (!this->MakeRequest(request))
  {
    return false;
  }
  request.isFinal = true;
  return this->TakeOver(palpate::makeResponses(request, report));
}

void vtkContactSetup::Request()
{
  palpate::ResponseRequest request;
  if (this->GetMTime() > this->Kept->requested && this->MakeRequest(request))
  {
    this->Kept->background.submit(std::move(request));
  }
}

bool vtkContactSetup::IsBusy()
{
  return this->Kept->background.isBusy();
}

double vtkContactSetup::GetProgress()
{
  return this->IsBusy() ? this->Kept->background.fraction() : 1.0;
}

std::string vtkContactSetup::GetPendingText()
{
  const State& kept = *this->Kept;
  if (!this->IsBusy() || !kept.output)
  {
    return {};
  }
  if (kept.made.isPreliminary)
  {
    return "Computing: error and validity are still those of nu = " +
      palpate::shortly(kept.shown.poissonRatio);
  }
  std::string former;
  const auto add = [&former](bool differs, const std::string& what)
  { former += !differs ? "" : (former.empty() ? "" : ", ") + what; };
  const double modulus = kept.shown.youngsModulus;
  add(modulus != this->YoungsModulus,
    "E = " +
      (modulus < 1.0 ? palpate::shortly(1000.0 * modulus) + " kPa"
                     : palpate::shortly(modulus) + " MPa"));
  add(kept.shown.poissonRatio != this->PoissonRatio,
    "nu = " + palpate::shortly(kept.shown.poissonRatio));
  const auto chosen = static_cast<std::size_t>(this->ChosenTool);
  vtkContactTool* tool = this->GetToolInHand();
  if (tool && tool->HasSize() && chosen < kept.shown.sizes.size())
  {
    const double size = kept.shown.sizes[chosen];
    add(size != tool->GetSize(),
      tool->IsSizeAngle() ? "half angle " + palpate::shortly(size) + " degrees"
                          : "radius " + palpate::shortly(size) + " mm");
  }
  constexpr std::array<const char*, 4> models = { "the half-space", "the layer",
    "the body in series", "the stored response" };
  add(kept.shown.model != this->Model, models[static_cast<std::size_t>(kept.shown.model)]);
  return "Computing: still the force of " + (former.empty() ? "the former settings" : former);
}

void vtkContactSetup::Cancel()
{
  State& kept = *this->Kept;
  if (!this->IsBusy())
  {
    return;
  }
  kept.background.cancel();
  kept.requested = 0;
  if (!kept.output)
  {
    return;
  }
  this->SetYoungsModulus(kept.shown.youngsModulus);
  this->SetPoissonRatio(kept.shown.poissonRatio);
  this->SetModel(kept.shown.model);
  this->Relaxations = kept.shown.relaxations;
  for (std::size_t i = 0; i < std::min(kept.tools.size(), kept.shown.sizes.size()); ++i)
  {
    if (kept.tools[i]->HasSize())
    {
      kept.tools[i]->SetSize(kept.shown.sizes[i]);
    }
  }
  palpate::ResponseRequest present;
  if (!this->MakeRequest(present) || !palpate::areEqual(kept.made.of, present))
  {
    kept.requested = 0; // a setting has changed that Cancel does not restore
  }
}

bool vtkContactSetup::Collect()
{
  auto made = this->Kept->background.collect();
  if (!made || made->from != this->Kept->copy || !this->TakeOver(std::move(*made)))
  {
    return false;
  }
  palpate::ResponseRequest request;
  if (this->Kept->made.isPreliminary && this->MakeRequest(request))
  {
    request.isFinal = true;
    this->Kept->background.submit(std::move(request));
  }
  return true;
}
