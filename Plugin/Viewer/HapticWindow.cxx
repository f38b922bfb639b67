// SPDX-License-Identifier: BSD-3-Clause
#include "HapticWindow.h"

#include "Response/Files/CollectingWindow.h"
#include "PictureSize.h"
#include "Pictures.h"
#include "ScenePath.h"
#include "SessionSettings.h"
#include "Haptics/Devices/TrajectoryFile.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
// Longest time between two frames, s. The record can store the ticks of this time.
constexpr double LongestFrame = 60.0;
constexpr double PanelWidth = 256.0; // width of the panel, pixels
constexpr double LargestPanelShare = 0.4;
constexpr double ChartShare = 0.28; // height of the charts, as a fraction of the window's height

/// Returns the force (N) that 90 % of the points do not exceed at this depth (mm), for the tool for
/// which this force is largest. (The maximum over all points would be the force at the thinnest
/// part of a layer.) Returns 1 if the curves are stored in the compact form.
double usualForce(const ResponseSet& responses, double depth)
{
  double usual = 0.0;
  for (const std::string& name : responses.names)
  {
    vtkPointData* data = responses.body->GetPointData();
    vtkDataArray* force = data->GetArray((name + "Force").c_str());
    vtkDataArray* range =
      data->GetArray(palpate::arrayName(name, palpate::ResponseArray::Range).c_str());
    if (!force || !range || force->GetNumberOfTuples() == 0)
    {
      continue;
    }
    // Sample i of n is at the deflection Range (i/n)^2.
    const int samples = force->GetNumberOfComponents();
    std::vector<double> forces;
    for (vtkIdType point = 0; point < force->GetNumberOfTuples(); ++point)
    {
      const double reach = range->GetTuple1(point);
      const double sample = reach > 0.0 ? samples * std::sqrt(depth / reach) : 1.0;
      const int column = static_cast<int>(std::clamp<double>(sample, 1.0, samples)) - 1;
      const double value = force->GetComponent(point, column);
      if (std::isfinite(value))
      {
        forces.push_back(value);
      }
    }
    const auto most = forces.begin() + static_cast<std::ptrdiff_t>(0.9 * forces.size());
    if (most != forces.end())
    {
      std::nth_element(forces.begin(), most, forces.end());
      usual = std::max(usual, *most);
    }
  }
  return usual > 0.0 ? usual : 1.0;
}

const char* const PressHint = "Turn the wheel over the body: the tool presses";

/// Sets the style of a small text in the upper left corner.
void styleHelp(vtkTextActor* help, double red, double green, double blue)
{
  help->GetTextProperty()->SetFontSize(15);
  help->GetTextProperty()->SetColor(red, green, blue);
  help->GetTextProperty()->SetVerticalJustificationToTop();
  help->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  help->GetPositionCoordinate()->SetValue(0.0125, 0.985);
}
} // namespace

HapticWindow::HapticWindow(
  const ViewerOptions& options, const ViewerScene& scene, const ResponseSet& responses)
  : Options(options)
  , Scene(scene)
  , Responses(responses)
  // The factor 2 is for the wheel, which can press deeper.
  , LargestForce(2.0 * usualForce(responses, scene.depth))
{
  // Without a graphics card, multisampling would triple the rendering time; FXAA does not increase
  // it.
  this->Window->SetMultiSamples(0);
  this->Renderer->UseFXAAOn();
  fitToScreen(this->Window);
  this->Window->SetWindowName(("Palpate: " + scene.title).c_str());
  this->Window->AddRenderer(this->Renderer);
  this->Interactor->SetRenderWindow(this->Window);
  styleHelp(this->Help, 0.35, 0.35, 0.38);
  styleHelp(this->Hint, 0.00, 0.36, 0.58);
  this->Hint->GetTextProperty()->BoldOn();
  this->Hint->SetInput(PressHint);
  this->View->SetRenderer(this->Renderer);
  this->View->SetBody(responses.body);
  this->View->SetTool(responses.tools.front());
  this->View->SetTitle(scene.title);
  this->View->SetPoissonRatio(scene.poissonRatio);
  this->View->SetLargestDeflection(options.maximumDeflection);
  this->View->SetLargestForce(this->LargestForce);
  this->Session->SetBody(responses.body);
  this->Session->SetRate(options.rate);
  chooseContact(options, scene, this->Session);
  this->Session->RealTimeOn();
  this->Session->LockMemoryOn(); // permitted, because the servo loop is the purpose of this program
  this->Session->GetRecorder()->SetRecording(!options.record.empty());
  this->Session->GetRecorder()->SetRecordedSeconds(LongestFrame);
  this->Clock->SetInteractor(this->Interactor);
  this->View->Follow(this->Clock, this->Session);
  this->Files->SetSession(this->Session);
  this->Files->SetWindow(this->Window);
  this->Files->SetOutputFolder(options.output);
  this->Style->SetSession(this->Session);
  this->Style->SetScene(this->View);
  this->Style->SetFiles(this->Files);
  this->Style->SetMaximumDepth(options.maximumDeflection);
  this->Style->SetPressDepth(scene.depth);
  this->Interactor->SetInteractorStyle(this->Style);
  this->onFrame(
    [this]
    {
      this->StrongestForces.resize(static_cast<std::size_t>(this->Session->GetNumberOfDevices()));
      for (std::size_t hand = 1; hand < this->StrongestForces.size(); ++hand)
      {
        const Tick& tick = this->Session->GetNewestTick(static_cast<int>(hand));
        this->StrongestForces[hand] = std::max(this->StrongestForces[hand], tick.idealForce.norm());
      }
    });
}

void HapticWindow::showHelp(const std::string& text)
{
  this->HelpText = text;
  this->placeHelp();
  this->Renderer->AddViewProp(this->Help); // a repeated call has no effect
}

/// Moves the help one line lower while the hint is shown. Removes the hint after the wheel has
/// pressed the tool.
void HapticWindow::placeHelp()
{
  if (this->Style->HasWheelPressed())
  {
    this->Renderer->RemoveViewProp(this->Hint);
  }
  const bool hinted = this->Renderer->HasViewProp(this->Hint);
  this->Help->SetInput((hinted ? "\n" + this->HelpText : this->HelpText).c_str());
}

void HapticWindow::open()
{
  bool followsMouse = false;
  for (int hand = this->Session->GetNumberOfDevices() - 1; hand >= 0; --hand)
  {
    if (this->Session->GetDevice(hand)->IsSimulated()) // only simulated devices follow the mouse
    {
      const TouchSite begin = siteOfHand(this->Scene, this->Responses.body, hand);
      this->Style->SetHand(hand);
      this->Style->HoverAt(begin.point.data(), begin.normal.data());
      followsMouse = true;
    }
  }
  const TouchSite site = firstSite(this->Scene, this->Responses.body);
  const std::array<double, 3> tip = site.above(this->Style->GetHoverHeight());
  const double none[3] = { 0.0, 0.0, 0.0 };
  this->Interactor->Initialize();
  if (followsMouse)
  {
    this->Renderer->AddViewProp(this->Hint);
    this->onFrame([this] { this->placeHelp(); });
    this->placeHelp();
  }
  if (this->HasPanel)
  {
    this->Panel->On();
  }
  this->View->ShowContact(tip.data(), site.point.data(), site.normal.data(), none, 0.0, -1);
  this->View->LookAtBody(this->Scene.viewFrom.data(), this->Scene.up.data());
  this->Window->Render();
  std::printf("window open\n");
  std::fflush(stdout);
}

std::string HapticWindow::run()
{
  this->onFrame(
    [this]
    {
      if (this->Signals.any())
      {
        this->close();
      }
    });
  this->Clock->Start();
  this->Interactor->Start();
  std::string error;
  if (!this->Options.screenshot.empty())
  {
    error = writePicture(this->Window, this->Options.screenshot);
  }
  const std::string unrecorded = this->end();
  return error.empty() ? unrecorded : error;
}

std::string HapticWindow::end()
{
  this->Session->Stop();
  this->printSummary();
  return this->writeRecords();
}

void HapticWindow::onTool(std::function<void(int)> action)
{
  this->Actions.add(this->Panel, vtkContactPanel::ToolShownEvent,
    [action = std::move(action)](void* tool) { action(*static_cast<const int*>(tool)); });
}

void HapticWindow::onNumber(std::function<void(int)> action)
{
  this->Actions.add(this->Style, vtkInteractorStyleHaptic::ToolChosenEvent,
    [action = std::move(action)](void* number) { action(*static_cast<const int*>(number)); });
}

void HapticWindow::onFrame(std::function<void()> action)
{
  this->Actions.add(
    this->Clock, vtkFrameClock::FrameEvent, [action = std::move(action)](void*) { action(); });
}

void HapticWindow::onSpace(std::function<void()> action)
{
  this->Actions.add(this->Style, vtkInteractorStyleHaptic::SwitchEvent,
    [action = std::move(action)](void*) { action(); });
}

void HapticWindow::usePanel(vtkContactSetup* setup)
{
  this->HasPanel = true;
  this->Window->AddRenderer(this->PanelRenderer);
  this->Window->AddRenderer(this->ChartRenderer);
  this->Charts->SetRenderer(this->ChartRenderer);
  this->Charts->SetSession(this->Session);
  this->Charts->SetLargestForce(this->LargestForce);
  this->Charts->SetLargestDeflection(this->Options.maximumDeflection);
  this->Panel->SetRenderer(this->PanelRenderer);
  this->Panel->SetSetup(setup);
  this->Panel->SetStyle(this->Style);
  this->Panel->SetClock(this->Clock);
  this->Panel->SetCharts(this->Charts);
  this->arrange();
  this->onFrame(
    [this]
    {
      this->arrange();
      if (this->Panel->GetChartsVisibility())
      {
        this->Charts->Update();
      }
    });
}

/// Keeps the width of the panel in pixels constant, regardless of the size of the window.
void HapticWindow::arrange()
{
  if (!this->HasPanel)
  {
    return;
  }
  const double width = std::max(this->Window->GetSize()[0], 1);
  const double right = 1.0 - std::min(PanelWidth / width, LargestPanelShare);
  const bool hasCharts = this->Panel->GetChartsVisibility();
  const double bottom = hasCharts ? ChartShare : 0.0;
  this->Renderer->SetViewport(0.0, bottom, right, 1.0);
  this->PanelRenderer->SetViewport(right, 0.0, 1.0, 1.0);
  this->ChartRenderer->SetViewport(0.0, 0.0, right, ChartShare);
  this->ChartRenderer->SetDraw(hasCharts);
}

void HapticWindow::printSummary()
{
  vtkNew<vtkTable> statistics;
  this->Session->GetRecorder()->GetStatistics(statistics);
  std::printf("%lld ticks, %lld missed; strongest force %.4g N\n",
    static_cast<long long>(this->Session->GetNumberOfTicks()),
    static_cast<long long>(this->Session->GetRecorder()->GetNumberOfMissedTicks()),
    statistics->GetValueByName(0, "PeakForce (N)").ToDouble());
  for (std::size_t hand = 1; hand < this->StrongestForces.size(); ++hand)
  {
    std::printf("hand %zu: strongest force %.4g N, device %s\n", hand + 1,
      this->StrongestForces[hand],
      this->Session->GetDevice(static_cast<int>(hand))->GetStatus().c_str());
  }
  std::printf("device: %s\n%s", this->Session->GetDevice()->GetStatus().c_str(),
    this->Session->GetRecorder()->GetStatisticsText().c_str());
}

std::string HapticWindow::writeRecords()
{
  const QuietScope quiet;
  const bool isWritten = !this->Files->IsRecording() || !this->Files->WriteRecording().empty();
  std::string error = isWritten ? std::string() : this->Files->GetNotice();
  if (!this->Options.record.empty())
  {
    const std::string failed = writeTrajectory(this->Options.record,
      this->Session->GetRecorder()->GetTicks(), this->Session->GetRecorder()->GetSetups());
    error += (error.empty() || failed.empty() ? "" : "; ") + failed;
  }
  return error;
}
} // namespace palpate
