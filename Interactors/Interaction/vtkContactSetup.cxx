// SPDX-License-Identifier: BSD-3-Clause
#include "vtkContactSetup.h"

#include "Interaction/Session/NewestRequest.h"
#include "Interaction/Session/ResponseMaker.h"
#include "vtkContactScene.h"
#include "vtkContactSettings.h"
#include "vtkContactTool.h"
#include "vtkHapticSession.h"
#include "vtkToolContactResponse.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace
{
const char* const ThicknessArray = "LayerThickness";
const char* const FirstArray = "LayerThickness0"; // of a stack
const char* const SecondArray = "LayerThickness1";
const char* const ComplianceArray = "GlobalCompliance";

using Tool = vtkSmartPointer<vtkContactTool>;

/// For another thread.
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

/// The body as it is on the screen, with the arrays that another thread added to a copy of it.
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

struct vtkContactSetup::State
{
  vtkSmartPointer<vtkPolyData> body;
  vtkSmartPointer<vtkPolyData> copy; ///< of the body, for the other thread
  std::vector<Tool> tools;
  std::vector<palpate::StackLayer> added; ///< layers below the first

  vtkSmartPointer<vtkPolyData> output;
  palpate::MadeResponses made; ///< what the output was assembled from
  vtkMTimeType requested = 0;  ///< as of when responses were last asked for

  /// Last, so that it ends first.
  palpate::NewestRequest<palpate::ResponseRequest, palpate::MadeResponses> background{
    palpate::makeResponses
  };
};

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

bool vtkContactSetup::HasToolSize()
{
  vtkContactTool* tool = this->GetTool(this->ChosenTool);
  return tool && tool->GetShape() != vtkContactTool::PowerLaw &&
    tool->GetShape() != vtkContactTool::Profile;
}

bool vtkContactSetup::IsToolSizeAngle()
{
  vtkContactTool* tool = this->GetTool(this->ChosenTool);
  return tool && tool->GetShape() == vtkContactTool::Cone;
}

void vtkContactSetup::SetToolSize(double size)
{
  if (this->IsToolSizeAngle())
  {
    this->GetTool(this->ChosenTool)->SetHalfAngle(size);
  }
  else if (this->HasToolSize())
  {
    this->GetTool(this->ChosenTool)->SetRadius(size);
  }
}

double vtkContactSetup::GetToolSize()
{
  vtkContactTool* tool = this->GetTool(this->ChosenTool);
  return !this->HasToolSize() ? 0.0
    : this->IsToolSizeAngle() ? tool->GetHalfAngle()
                              : tool->GetRadius();
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
          data->HasArray(this->Kept->added.empty() ? ThicknessArray : FirstArray));
    case Series:
      return this->Model != Stored && data->HasArray(ComplianceArray);
    case Stored:
      return data->HasArray("ResponseRange");
    default:
      return false;
  }
}

bool vtkContactSetup::MakeRequest(palpate::ResponseRequest& request)
{
  State& kept = *this->Kept;
  this->Error = !kept.body ? "A body is required: call SetBody."
    : kept.tools.empty()   ? "A tool is required: call AddTool."
    : !this->HasModel(this->Model)
    ? "The body has not what model " + std::to_string(this->Model) + " needs."
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
  this->Error = this->Relaxations.felt().fillSeries(request.relaxation.series);
  if (!this->Error.empty())
  {
    vtkErrorMacro(<< this->Error << ".");
    return false;
  }
  request.relaxation.complianceRelaxes = this->ComplianceRelaxes;
  request.tolerance = this->Tolerance;
  request.choiceDeflection = this->ChoiceDeflection;
  if (this->Model == Layer)
  {
    request.layerThickness = this->LayerThickness;
    const char* first = kept.added.empty() ? ThicknessArray : FirstArray;
    request.thicknessArray = this->LayerThickness > 0.0 ? "" : first;
    request.deeper = kept.added;
    if (!kept.added.empty() && kept.added.front().thickness == 0.0)
    {
      request.secondArray = SecondArray;
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
    request.complianceArray = ComplianceArray;
    request.complianceFactor =
      this->ComplianceModulus > 0.0 ? this->ComplianceModulus / this->YoungsModulus : 1.0;
  }
  const auto& known = kept.made.kernels.read;
  request.surface = known.empty() ? nullptr : known.begin()->second;
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
  kept.made = std::move(made);
  kept.output = withAddedArrays(kept.body, kept.made);
  kept.made.body = nullptr;
  return true;
}

bool vtkContactSetup::Update()
{
  this->Kept->background.cancel();
  palpate::ResponseRequest request;
  return this->MakeRequest(request) &&
    this->TakeOver(palpate::makeResponses(request, [] { return false; }));
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

bool vtkContactSetup::Collect()
{
  auto made = this->Kept->background.collect();
  return made && made->from == this->Kept->copy && this->TakeOver(std::move(*made));
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
  this->Settings = settings; // not Modified: no response depends on them
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
  if (session->GetBody() != this->Kept->output)
  {
    session->SetBody(this->Kept->output, this->Kept->made.kernels);
  }
  session->SetResponseName(this->GetResponseName(this->ChosenTool));
  if (this->Settings)
  {
    session->SetSettings(this->Settings);
  }
  session->GetSettings()->SetPoissonRatio(this->Kept->made.poissonRatio);
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
  for (const Tool& tool : this->Kept->tools)
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
