// SPDX-License-Identifier: BSD-3-Clause
#include "vtkContactPanel.h"

#include "Interaction/Panel/PanelLook.h"
#include "Interaction/Panel/PanelSheet.h"
#include "vtkContactScene.h"
#include "vtkContactSetup.h"
#include "vtkContactTool.h"
#include "vtkHapticSession.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkLiveCharts.h"

#include "vtkCallbackCommand.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <array>
#include <iomanip>
#include <sstream>
#include <utility>

namespace
{
using palpate::PanelButton;
using palpate::PanelScale;
using palpate::PanelSlider;

constexpr PanelScale RadiusScale{ 0.5, 20.0, true, 0.01 };
constexpr PanelScale AngleScale{ 10.0, 85.0, false, 1.0 };
constexpr PanelScale ModulusScale{ 0.001, 10.0, true, 0.01 };
constexpr PanelScale PoissonScale{ 0.0, 0.5, false, 0.01 };
constexpr PanelScale FrictionScale{ 0.0, 1.0, false, 0.01 };
constexpr PanelScale ExaggerationScale{ 1.0, 64.0, true, 0.1 };
constexpr double Priority = 1.0; // of the panel among the observers of a frame: before others

const std::array<const char*, 4> ModelNames = { "Half-space", "Layer", "In series", "Stored" };

std::string digits(double value, int count)
{
  std::ostringstream written;
  written << std::setprecision(count) << value;
  return written.str();
}

std::string decimals(double value, int count)
{
  std::ostringstream written;
  written << std::fixed << std::setprecision(count) << value;
  return written.str();
}

/// What a tool's description says, in the width of a button.
std::string toolText(vtkContactTool* tool)
{
  std::string text = tool->GetDescription();
  const std::array<std::pair<const char*, const char*>, 3> shorter = { { { ", radius ", ", " },
    { ", half angle ", ", " }, { " degrees", "°" } } };
  for (const auto& [words, instead] : shorter)
  {
    const std::size_t place = text.find(words);
    if (place != std::string::npos)
    {
      text.replace(place, std::string(words).size(), instead);
    }
  }
  return text;
}

std::string modulusText(double value)
{
  return value < 1.0 ? digits(1000.0 * value, 3) + " kPa" : digits(value, 3) + " MPa";
}
std::string radiusText(double value)
{
  return digits(value, 3) + " mm";
}
std::string angleText(double value)
{
  return digits(value, 3) + "°";
}
std::string ratioText(double value)
{
  return decimals(value, 2);
}
std::string exaggerationText(double value)
{
  return digits(value, 2) + " times";
}
} // namespace

struct vtkContactPanel::Parts
{
  vtkSmartPointer<vtkRenderer> renderer;
  vtkSmartPointer<vtkContactSetup> setup;
  vtkSmartPointer<vtkInteractorStyleHaptic> style;
  vtkSmartPointer<vtkLiveCharts> charts;

  palpate::PanelSheet sheet;
  std::vector<PanelButton*> tools;
  std::array<PanelButton*, 4> models{};
  PanelSlider* size = nullptr;
  PanelSlider* modulus = nullptr;
  PanelSlider* poisson = nullptr;
  PanelSlider* friction = nullptr;
  PanelSlider* exaggeration = nullptr;
  PanelButton* compare = nullptr;
  PanelButton* showCharts = nullptr;
  PanelButton* timing = nullptr;
  PanelButton* session = nullptr;
  PanelButton* record = nullptr;

  bool sizeIsAngle = false;
  double shownForce = 0.0; ///< to which the scales of force were fitted, N
  vtkNew<vtkCallbackCommand> follow;

  vtkHapticSession* haptics() { return this->style ? this->style->GetSession() : nullptr; }
  vtkContactScene* scene() { return this->style ? this->style->GetScene() : nullptr; }
};

vtkStandardNewMacro(vtkContactPanel);

vtkContactPanel::vtkContactPanel()
  : Kept(std::make_unique<Parts>())
{
  this->Kept->follow->SetClientData(this);
  this->Kept->follow->SetCallback(
    [](vtkObject*, unsigned long event, void* client, void* data)
    {
      auto* panel = static_cast<vtkContactPanel*>(client);
      vtkLiveCharts* charts = panel->Kept->charts;
      switch (event)
      {
        case vtkInteractorStyleHaptic::FrameEvent:
          panel->Update();
          break;
        case vtkInteractorStyleHaptic::ToolChosenEvent:
          panel->ChooseTool(*static_cast<const int*>(data));
          break;
        case vtkInteractorStyleHaptic::CompareEvent:
          panel->SetCompare(!panel->GetCompare());
          break;
        case vtkInteractorStyleHaptic::ChartsEvent:
          panel->SetChartsVisibility(!panel->GetChartsVisibility());
          break;
        case vtkInteractorStyleHaptic::HistogramEvent:
          if (charts)
          {
            charts->SetHistogramVisibility(!charts->GetHistogramVisibility());
          }
          break;
        default:
          break;
      }
    });
}

vtkContactPanel::~vtkContactPanel()
{
  this->Off();
}

void vtkContactPanel::SetRenderer(vtkRenderer* renderer)
{
  this->Kept->renderer = renderer;
  if (renderer)
  {
    renderer->SetBackground(palpate::PanelColor[0], palpate::PanelColor[1], palpate::PanelColor[2]);
    renderer->InteractiveOff();
  }
}

void vtkContactPanel::SetSetup(vtkContactSetup* setup)
{
  this->Kept->setup = setup;
}

void vtkContactPanel::SetStyle(vtkInteractorStyleHaptic* style)
{
  this->Kept->style = style;
}

void vtkContactPanel::SetCharts(vtkLiveCharts* charts)
{
  this->Kept->charts = charts;
}

void vtkContactPanel::On()
{
  Parts& kept = *this->Kept;
  if (!kept.renderer || !kept.setup || !kept.haptics() || !kept.scene() ||
    !kept.style->GetInteractor() || !kept.setup->GetOutput())
  {
    vtkErrorMacro(<< "A panel needs a renderer, a setup with an output, and a style with session, "
                  << "scene and interactor.");
    return;
  }
  this->Off();
  this->MakeControls();
  kept.shownForce = kept.setup->GetLargestForce();
  kept.sheet.show(kept.renderer, kept.style->GetInteractor());
  for (const unsigned long event : { vtkInteractorStyleHaptic::FrameEvent,
         vtkInteractorStyleHaptic::ToolChosenEvent, vtkInteractorStyleHaptic::CompareEvent,
         vtkInteractorStyleHaptic::ChartsEvent, vtkInteractorStyleHaptic::HistogramEvent })
  {
    kept.style->AddObserver(event, kept.follow, Priority);
  }
  this->ShowValues();
  kept.sheet.place();
}

void vtkContactPanel::Off()
{
  if (this->Kept->style)
  {
    this->Kept->style->RemoveObserver(this->Kept->follow);
  }
  this->Kept->sheet.clear();
}

void vtkContactPanel::MakeControls()
{
  Parts& kept = *this->Kept;
  kept.tools.clear();
  kept.models = {};
  if (kept.setup->GetModel() == vtkContactSetup::Stored)
  {
    kept.size = kept.modulus = kept.poisson = nullptr;
  }
  this->MakeSetupControls();
  this->MakeShowControls();
}

void vtkContactPanel::MakeSetupControls()
{
  Parts& kept = *this->Kept;
  palpate::PanelSheet& sheet = kept.sheet;
  const bool isStored = kept.setup->GetModel() == vtkContactSetup::Stored;
  const auto read = [this] { this->ReadControls(); };
  const auto fit = [this] { this->FitScales(); };
  sheet.addHeading("TOOL");
  for (int tool = 0; tool < kept.setup->GetNumberOfTools(); ++tool)
  {
    kept.tools.push_back(sheet.addButton("", [this, tool] { this->ChooseTool(tool); }));
  }
  if (!isStored)
  {
    kept.size = sheet.addSlider(read, fit);
    kept.sizeIsAngle = true;
    kept.size->setMeaning("Half angle", AngleScale, angleText);
    sheet.addHeading("MATERIAL");
    kept.modulus = sheet.addSlider(read, fit);
    kept.modulus->setMeaning("Young's modulus", ModulusScale, modulusText);
    kept.poisson = sheet.addSlider(read, fit);
    kept.poisson->setMeaning("Poisson's ratio", PoissonScale, ratioText);
  }
  else
  {
    sheet.addHeading("CONTACT");
  }
  kept.friction = sheet.addSlider(read, [] {});
  kept.friction->setMeaning("Friction", FrictionScale, ratioText);
  if (isStored)
  {
    return;
  }
  sheet.addHeading("MODEL OF THE BODY");
  int count = 0;
  for (int model = 0; model < static_cast<int>(ModelNames.size()); ++model)
  {
    count += kept.setup->HasModel(model) && model != vtkContactSetup::Stored ? 1 : 0;
  }
  for (int model = 0; model < vtkContactSetup::Stored; ++model)
  {
    if (kept.setup->HasModel(model))
    {
      const auto index = static_cast<std::size_t>(model);
      kept.models[index] = sheet.addButton(
        ModelNames[index], [this, model] { this->Kept->setup->SetModel(model); }, count);
    }
  }
}

void vtkContactPanel::MakeShowControls()
{
  Parts& kept = *this->Kept;
  palpate::PanelSheet& sheet = kept.sheet;
  vtkInteractorStyleHaptic* style = kept.style;
  sheet.addHeading("VIEW");
  kept.exaggeration = sheet.addSlider([this] { this->ReadControls(); }, [] {});
  kept.exaggeration->setMeaning("Dent drawn deeper", ExaggerationScale, exaggerationText);
  kept.compare = kept.showCharts = kept.timing = nullptr;
  if (kept.charts)
  {
    kept.showCharts = sheet.addButton(
      "Charts", [this] { this->SetChartsVisibility(!this->ChartsVisibility); }, 2);
    kept.timing = sheet.addButton(
      "Timing",
      [this]
      {
        vtkLiveCharts* charts = this->Kept->charts;
        charts->SetHistogramVisibility(!charts->GetHistogramVisibility());
      },
      2);
    kept.compare = sheet.addButton(
      "Compare", [this] { this->SetCompare(!this->Compare); }, 2);
  }
  sheet.addButton(
    "Keys: ?", [style] { style->SetHelpVisibility(!style->GetHelpVisibility()); },
    kept.charts ? 2 : 1);
  sheet.addHeading("SESSION");
  kept.session = sheet.addButton(
    "Stop", [style] { style->ToggleSession(); }, 3);
  kept.record = sheet.addButton(
    "Record", [style] { style->ToggleRecording(); }, 3);
  sheet.addButton(
    "Picture", [style] { style->WritePicture(); }, 3);
  sheet.addStatus();
}

/// What the sliders say goes to those they are for; responses follow at the next frame.
void vtkContactPanel::ReadControls()
{
  Parts& kept = *this->Kept;
  vtkContactSetup* setup = kept.setup;
  if (kept.size && kept.size->isHeld())
  {
    setup->SetToolSize(kept.size->quantity());
  }
  if (kept.modulus && kept.modulus->isHeld())
  {
    setup->SetYoungsModulus(kept.modulus->quantity());
  }
  if (kept.poisson && kept.poisson->isHeld())
  {
    setup->SetPoissonRatio(kept.poisson->quantity());
  }
  if (kept.friction->isHeld() &&
    kept.friction->quantity() != kept.haptics()->GetFrictionCoefficient())
  {
    kept.haptics()->SetFrictionCoefficient(kept.friction->quantity());
    kept.haptics()->ApplyChanges();
  }
  if (kept.exaggeration->isHeld())
  {
    kept.scene()->SetExaggeration(kept.exaggeration->quantity());
  }
}

void vtkContactPanel::Update()
{
  Parts& kept = *this->Kept;
  if (!kept.sheet.isShown())
  {
    return;
  }
  kept.setup->Request();
  if (kept.setup->Collect())
  {
    this->ApplyResponses();
  }
  this->ShowValues();
  this->ShowStatus();
  kept.sheet.place();
}

void vtkContactPanel::ApplyResponses()
{
  Parts& kept = *this->Kept;
  kept.setup->ApplyTo(kept.haptics());
  kept.setup->ShowIn(kept.scene());
  if (!kept.size || !(kept.size->isHeld() || kept.modulus->isHeld() || kept.poisson->isHeld()))
  {
    this->FitScales();
  }
}

/// While a slider is held the scales of force stay, so that the change is seen; then they are
/// chosen anew if forces have become much larger or smaller.
void vtkContactPanel::FitScales()
{
  constexpr double muchLarger = 1.5;
  constexpr double muchSmaller = 0.3;
  Parts& kept = *this->Kept;
  const double force = kept.setup->GetLargestForce();
  const double ratio = force / kept.shownForce;
  if (force > 0.0 && !kept.setup->IsBusy() && !(ratio < muchLarger && ratio > muchSmaller))
  {
    kept.shownForce = force;
    kept.scene()->SetLargestForce(force);
    if (kept.charts)
    {
      kept.charts->ResetRanges();
    }
  }
}

void vtkContactPanel::ChooseTool(int tool)
{
  Parts& kept = *this->Kept;
  if (kept.setup->GetTool(tool) && tool != kept.setup->GetChosenTool())
  {
    kept.setup->SetChosenTool(tool);
    kept.setup->ApplyTo(kept.haptics());
    kept.setup->ShowIn(kept.scene());
    this->InvokeEvent(ToolShownEvent, &tool);
  }
}

void vtkContactPanel::SetCompare(bool compare)
{
  vtkLiveCharts* charts = this->Kept->charts;
  if (compare == this->Compare || !charts)
  {
    return;
  }
  this->Compare = compare;
  charts->RemoveAllComparedResponses();
  for (int tool = 0; compare && tool < this->Kept->setup->GetNumberOfTools(); ++tool)
  {
    charts->AddComparedResponse(this->Kept->setup->GetResponseName(tool));
  }
  this->Modified();
}

void vtkContactPanel::SetChartsVisibility(bool visible)
{
  if (this->Kept->charts && visible != this->ChartsVisibility)
  {
    this->ChartsVisibility = visible;
    this->Modified();
  }
}

void vtkContactPanel::ShowValues()
{
  Parts& kept = *this->Kept;
  vtkContactSetup* setup = kept.setup;
  for (int tool = 0; tool < static_cast<int>(kept.tools.size()); ++tool)
  {
    PanelButton* button = kept.tools[static_cast<std::size_t>(tool)];
    button->setLabel(std::to_string(tool + 1) + "   " + toolText(setup->GetTool(tool)));
    button->setOn(tool == setup->GetChosenTool());
  }
  if (kept.size)
  {
    if (setup->IsToolSizeAngle() != kept.sizeIsAngle)
    {
      kept.sizeIsAngle = setup->IsToolSizeAngle();
      kept.size->setMeaning(kept.sizeIsAngle ? "Half angle" : "Radius",
        kept.sizeIsAngle ? AngleScale : RadiusScale, kept.sizeIsAngle ? angleText : radiusText);
    }
    kept.size->SetVisibility(setup->HasToolSize());
    kept.size->setQuantity(setup->GetToolSize());
    kept.modulus->setQuantity(setup->GetYoungsModulus());
    kept.poisson->setQuantity(setup->GetPoissonRatio());
  }
  kept.friction->setQuantity(kept.haptics()->GetFrictionCoefficient());
  kept.exaggeration->setQuantity(kept.scene()->GetExaggeration());
  for (int model = 0; model < static_cast<int>(kept.models.size()); ++model)
  {
    if (PanelButton* button = kept.models[static_cast<std::size_t>(model)])
    {
      button->setOn(model == setup->GetModel());
    }
  }
  if (kept.charts)
  {
    kept.showCharts->setOn(this->ChartsVisibility);
    kept.timing->setOn(kept.charts->GetHistogramVisibility());
    kept.compare->setOn(this->Compare);
  }
  kept.session->setLabel(
    kept.haptics()->GetState() == vtkHapticSession::Stopped ? "Start" : "Stop");
  kept.record->setOn(kept.style->IsRecording());
}

void vtkContactPanel::ShowStatus()
{
  Parts& kept = *this->Kept;
  std::string status = kept.style->GetNotice();
  if (kept.style->IsRecording())
  {
    status = "recording: " +
      decimals(
        static_cast<double>(kept.style->GetNumberOfRecordedTicks()) / kept.haptics()->GetRate(),
        1) +
      " s";
  }
  if (!kept.setup->GetError().empty())
  {
    status = kept.setup->GetError();
  }
  if (kept.setup->IsBusy())
  {
    status = "computing the responses ...";
  }
  kept.sheet.setStatus(status);
}

bool vtkContactPanel::FindButton(const std::string& label, int position[2])
{
  for (const auto& button : this->Kept->sheet.buttons())
  {
    if (button->GetVisibility() && button->label() == label)
    {
      double middle[2];
      button->findMiddle(middle);
      const int* origin = this->Kept->renderer->GetOrigin();
      position[0] = origin[0] + static_cast<int>(middle[0]);
      position[1] = origin[1] + static_cast<int>(middle[1]);
      return true;
    }
  }
  return false;
}

bool vtkContactPanel::FindSlider(const std::string& name, double value, int position[2])
{
  for (const auto& slider : this->Kept->sheet.sliders())
  {
    if (slider->GetVisibility() && slider->name() == name)
    {
      double handle[2];
      slider->findHandle(value, handle);
      const int* origin = this->Kept->renderer->GetOrigin();
      position[0] = origin[0] + static_cast<int>(handle[0] + 0.5);
      position[1] = origin[1] + static_cast<int>(handle[1]);
      return true;
    }
  }
  return false;
}

std::string vtkContactPanel::GetStatus()
{
  return this->Kept->sheet.status();
}

void vtkContactPanel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Compare: " << this->Compare << "\n";
  os << indent << "ChartsVisibility: " << this->ChartsVisibility << "\n";
  os << indent << "Status: " << this->GetStatus() << "\n";
}
