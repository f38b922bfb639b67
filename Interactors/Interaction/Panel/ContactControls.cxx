// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Panel/ContactControls.h"

#include "vtkContactScene.h"
#include "vtkContactSetup.h"
#include "vtkContactTool.h"
#include "vtkHapticSession.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkLiveCharts.h"
#include "vtkSessionFiles.h"

#include <array>
#include <iomanip>
#include <sstream>
#include <utility>

namespace palpate
{
namespace
{
constexpr PanelScale RadiusScale{ 0.5, 20.0, true, 0.01 };
constexpr PanelScale AngleScale{ 10.0, 85.0, false, 1.0 };
constexpr PanelScale ModulusScale{ 0.001, 10.0, true, 0.01 };
constexpr PanelScale PoissonScale{ 0.0, 0.5, false, 0.01 };
constexpr PanelScale StrengthScale{ 0.0, 3.0, false, 0.05 };
constexpr PanelScale SecondsScale{ 0.01, 100.0, true, 0.01 };
constexpr double FirstSeconds = 1.0; ///< relaxation time added to a body without relaxation, s
constexpr PanelScale FrictionScale{ 0.0, 1.0, false, 0.01 };
constexpr PanelScale ExaggerationScale{ 1.0, 64.0, true, 0.1 };

const std::array<const char*, 3> ModelNames = { "Half-space", "Layer", "In series" };

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

/// Returns the description of a tool, shortened to the width of a button.
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
std::string strengthText(double value)
{
  return value > 0.0 ? decimals(value, 2) : "none";
}
std::string secondsText(double value)
{
  return digits(value, 3) + " s";
}
std::string exaggerationText(double value)
{
  return digits(value, 2) + " times";
}

/// If a request takes longer than this time, the panel shows the request and offers to cancel it.
constexpr std::chrono::milliseconds Patience{ 300 };

std::function<std::string()> always(const char* label)
{
  return [label] { return std::string(label); };
}
} // namespace

ContactControls::ContactControls(vtkContactSetup* setup, vtkInteractorStyleHaptic* style,
  vtkLiveCharts* charts, std::function<void(int)> toolShown)
  : Setup(setup)
  , Style(style)
  , Charts(charts)
  , ToolShown(std::move(toolShown))
  , ShownForce(setup->GetLargestForce())
{
}

ContactControls::~ContactControls() = default;

vtkHapticSession* ContactControls::session() const
{
  return this->Style->GetSession();
}

vtkContactScene* ContactControls::scene() const
{
  return this->Style->GetScene();
}

std::vector<ControlRow> ContactControls::rows()
{
  std::vector<ControlRow> rows;
  this->addContact(rows);
  this->addView(rows);
  this->addSession(rows);
  rows.emplace_back(ControlStatus{});
  // The button is below the progress in the status row, so that it moves no other row when it
  // appears.
  rows.emplace_back(
    std::vector<ControlButton>{ { always("Cancel"), [setup = this->Setup] { setup->Cancel(); },
      [] { return false; }, [this] { return this->isWaiting(); } } });
  return rows;
}

void ContactControls::addContact(std::vector<ControlRow>& rows)
{
  vtkContactSetup* setup = this->Setup;
  const bool isStored = setup->GetModel() == vtkContactSetup::Stored;
  rows.emplace_back("TOOL");
  for (int tool = 0; tool < setup->GetNumberOfTools(); ++tool)
  {
    rows.emplace_back(std::vector<ControlButton>{
      { [setup, tool] { return std::to_string(tool + 1) + "   " + toolText(setup->GetTool(tool)); },
        [this, tool] { this->chooseTool(tool); },
        [setup, tool] { return tool == setup->GetChosenTool(); } } });
  }
  if (!isStored)
  {
    const auto size = [setup]
    {
      vtkContactTool* tool = setup->GetToolInHand();
      return tool ? tool->GetSize() : 0.0;
    };
    const auto resize = [setup](double value)
    {
      if (vtkContactTool* tool = setup->GetToolInHand())
      {
        tool->SetSize(value);
      }
    };
    const auto isSize = [setup](bool angle)
    {
      vtkContactTool* tool = setup->GetToolInHand();
      return tool && tool->HasSize() && tool->IsSizeAngle() == angle;
    };
    rows.emplace_back(ControlQuantity{
      "Half angle", AngleScale, angleText, size, resize, true, [isSize] { return isSize(true); } });
    rows.emplace_back(ControlQuantity{
      "Radius", RadiusScale, radiusText, size, resize, true, [isSize] { return isSize(false); } });
    rows.emplace_back("MATERIAL");
    rows.emplace_back(ControlQuantity{ "Young's modulus", ModulusScale, modulusText,
      [setup] { return setup->GetYoungsModulus(); },
      [setup](double value) { setup->SetYoungsModulus(value); }, true });
    rows.emplace_back(ControlQuantity{ "Poisson's ratio", PoissonScale, ratioText,
      [setup] { return setup->GetPoissonRatio(); },
      [setup](double value) { setup->SetPoissonRatio(value); }, true });
    this->addRelaxation(rows);
  }
  else
  {
    rows.emplace_back("CONTACT");
  }
  rows.emplace_back(ControlQuantity{ "Friction", FrictionScale, ratioText,
    [this] { return this->session()->GetSettings()->GetFrictionCoefficient(); },
    [this](double value)
    {
      vtkContactSettings* settings = this->session()->GetSettings();
      if (value != settings->GetFrictionCoefficient())
      {
        settings->SetFrictionCoefficient(value);
        this->session()->ApplyChanges();
      }
    } });
  if (isStored)
  {
    return;
  }
  rows.emplace_back("MODEL OF THE BODY");
  std::vector<ControlButton> models;
  for (int model = 0; model < vtkContactSetup::Stored; ++model)
  {
    if (setup->HasModel(model))
    {
      const bool isStack = model == vtkContactSetup::Layer && setup->GetNumberOfAddedLayers() > 0;
      models.push_back({ always(isStack ? "Layers" : ModelNames[static_cast<std::size_t>(model)]),
        [setup, model] { setup->SetModel(model); },
        [setup, model] { return model == setup->GetModel(); } });
    }
  }
  rows.emplace_back(std::move(models));
}

/// Adds the controls for the first branch of the relaxation.
void ContactControls::addRelaxation(std::vector<ControlRow>& rows)
{
  vtkContactSetup* setup = this->Setup;
  const int count = setup->GetNumberOfRelaxations();
  const std::string which = count > 1 ? " 1 of " + std::to_string(count) : "";
  const auto strength = [setup]
  { return setup->GetNumberOfRelaxations() > 0 ? setup->GetRelaxationStrength(0) : 0.0; };
  const auto seconds = [setup]
  { return setup->GetNumberOfRelaxations() > 0 ? setup->GetRelaxationTime(0) : FirstSeconds; };
  rows.emplace_back(ControlQuantity{ "Relaxation" + which, StrengthScale, strengthText, strength,
    [setup, strength, seconds](double value)
    {
      if (value != strength())
      {
        setup->SetRelaxation(0, value, seconds());
      }
    } });
  rows.emplace_back(ControlQuantity{ "Relaxation time" + which, SecondsScale, secondsText, seconds,
    [setup, strength](double value) { setup->SetRelaxation(0, strength(), value); }, false,
    [strength] { return strength() > 0.0; } });
}

void ContactControls::addView(std::vector<ControlRow>& rows)
{
  rows.emplace_back("VIEW");
  rows.emplace_back(ControlQuantity{ "Dent drawn deeper", ExaggerationScale, exaggerationText,
    [this] { return this->scene()->GetExaggeration(); },
    [this](double value) { this->scene()->SetExaggeration(value); } });
  std::vector<ControlButton> last;
  if (this->Charts)
  {
    rows.emplace_back(std::vector<ControlButton>{
      { always("Charts"), [this] { this->setShowsCharts(!this->ShowsCharts); },
        [this] { return this->ShowsCharts; } },
      { always("Timing"), [this] { this->toggleTiming(); },
        [this] { return this->Charts->GetHistogramVisibility(); } } });
    last.push_back({ always("Compare"), [this] { this->setCompares(!this->Compares); },
      [this] { return this->Compares; } });
  }
  last.push_back({ always("Keys: ?"),
    [this] { this->Style->SetHelpVisibility(!this->Style->GetHelpVisibility()); } });
  rows.emplace_back(std::move(last));
}

void ContactControls::addSession(std::vector<ControlRow>& rows)
{
  const auto isStopped = [this]
  { return this->session()->GetState() == vtkHapticSession::Stopped; };
  rows.emplace_back("SESSION");
  std::vector<ControlButton> buttons;
  buttons.push_back({ [isStopped] { return std::string(isStopped() ? "Start" : "Stop"); },
    [this] { this->session()->Toggle(); } });
  if (vtkSessionFiles* files = this->Style->GetFiles())
  {
    buttons.push_back({ always("Record"), [files] { files->ToggleRecording(); },
      [files] { return files->IsRecording(); } });
    buttons.push_back({ always("Picture"), [files] { files->WritePicture(); } });
  }
  rows.emplace_back(std::move(buttons));
}

bool ContactControls::isWaiting() const
{
  return this->Waits && this->Setup->IsBusy();
}

bool ContactControls::update()
{
  this->Setup->Request();
  const auto now = std::chrono::steady_clock::now();
  this->BusySince = this->Setup->IsBusy() ? this->BusySince : now;
  this->Waits = now - this->BusySince > Patience;
  this->scene()->SetNotice(this->isWaiting() ? this->Setup->GetPendingText() : std::string());
  if (!this->Setup->Collect())
  {
    return false;
  }
  this->Setup->ApplyTo(this->session());
  this->Setup->ShowIn(this->scene());
  return true;
}

void ContactControls::fitScales()
{
  constexpr double muchLarger = 1.5;
  constexpr double muchSmaller = 0.3;
  const double force = this->Setup->GetLargestForce();
  const double ratio = force / this->ShownForce;
  if (force > 0.0 && !this->Setup->IsBusy() && !(ratio < muchLarger && ratio > muchSmaller))
  {
    const bool isKnown = this->ShownForce > 0.0;
    this->ShownForce = force;
    // If all forces change by one ratio, the scales are multiplied by the same ratio.
    this->scene()->SetLargestForce(isKnown ? ratio * this->scene()->GetLargestForce() : force);
    if (this->Charts)
    {
      this->Charts->SetLargestForce(isKnown ? ratio * this->Charts->GetLargestForce() : 0.0);
    }
  }
}

void ContactControls::chooseTool(int tool)
{
  if (this->Setup->GetTool(tool) && tool != this->Setup->GetChosenTool())
  {
    this->Setup->SetChosenTool(tool);
    this->Setup->ApplyTo(this->session());
    this->Setup->ShowIn(this->scene());
    this->ToolShown(tool);
  }
}

void ContactControls::setCompares(bool compares)
{
  if (compares == this->Compares || !this->Charts)
  {
    return;
  }
  this->Compares = compares;
  this->Charts->RemoveAllComparedResponses();
  for (int tool = 0; compares && tool < this->Setup->GetNumberOfTools(); ++tool)
  {
    this->Charts->AddComparedResponse(this->Setup->GetResponseName(tool));
  }
}

void ContactControls::setShowsCharts(bool shown)
{
  this->ShowsCharts = shown || !this->Charts;
}

void ContactControls::toggleTiming()
{
  if (this->Charts)
  {
    this->Charts->SetHistogramVisibility(!this->Charts->GetHistogramVisibility());
  }
}

std::string ContactControls::status() const
{
  vtkSessionFiles* files = this->Style->GetFiles();
  if (this->isWaiting())
  {
    return "computing the responses: " + decimals(100.0 * this->Setup->GetProgress(), 0) + " %";
  }
  if (!this->Setup->GetError().empty())
  {
    return this->Setup->GetError();
  }
  if (files && files->IsRecording())
  {
    const auto ticks = static_cast<double>(files->GetNumberOfRecordedTicks());
    return "recording: " + decimals(ticks / this->session()->GetRate(), 1) + " s";
  }
  if (this->Style->IsPointerOffBody())
  {
    return "pointer off the body: the tool keeps its place";
  }
  if (this->Style->IsAtGreatestDepth())
  {
    return "the greatest depth of these curves, " + digits(this->Style->GetMaximumDepth(), 3) +
      " mm";
  }
  return files ? files->GetNotice() : std::string();
}
} // namespace palpate
