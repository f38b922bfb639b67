// SPDX-License-Identifier: BSD-3-Clause
// Properties and updates of the charts. LiveChartsState.cxx does the work.
#include "vtkLiveCharts.h"

#include "Interaction/Charts/LiveChartsState.h"
#include "Haptics/Servo/TickHistory.h"
#include "Interaction/Session/TickRecording.h"

#include "vtkChartXY.h"
#include "vtkContextScene.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <algorithm>

namespace
{
vtkIdType firstPolyOf(vtkPolyData* body)
{
  return body->GetNumberOfVerts() + body->GetNumberOfLines();
}
} // namespace

vtkStandardNewMacro(vtkLiveCharts);

vtkLiveCharts::vtkLiveCharts()
  : Kept(std::make_unique<Parts>())
{
  for (const auto& [chart, isVisible] : this->Kept->all())
  {
    this->Kept->actor->GetScene()->AddItem(chart->chart());
  }
  this->Kept->histogram.chart()->SetVisible(false);
}

vtkLiveCharts::~vtkLiveCharts()
{
  this->SetRenderer(nullptr);
}

void vtkLiveCharts::SetRenderer(vtkRenderer* renderer)
{
  Parts& kept = *this->Kept;
  if (kept.renderer)
  {
    kept.renderer->RemoveViewProp(kept.actor);
  }
  kept.renderer = renderer;
  kept.actor->GetScene()->SetRenderer(renderer);
  if (renderer)
  {
    renderer->AddViewProp(kept.actor);
    renderer->SetBackground(palpate::BackgroundColor.data());
    renderer->InteractiveOff();
    kept.layOut();
  }
  this->Modified();
}

vtkRenderer* vtkLiveCharts::GetRenderer()
{
  return this->Kept->renderer;
}

void vtkLiveCharts::SetSession(vtkHapticSession* session)
{
  this->Kept->session = session;
  this->Kept->forget();
  if (session)
  {
    vtkHapticRecorder* recorder = session->GetRecorder();
    recorder->SetHistorySeconds(
      std::max(recorder->GetHistorySeconds(), this->Kept->time.seconds()));
    this->Kept->run = session->GetNumberOfStarts();
  }
  this->Modified();
}

vtkHapticSession* vtkLiveCharts::GetSession()
{
  return this->Kept->session;
}

void vtkLiveCharts::Update()
{
  Parts& kept = *this->Kept;
  if (!kept.session)
  {
    return;
  }
  // GetLastTicks is called first, because it may collect ticks. Curves and running point must
  // belong to the same tick.
  const bool runs = kept.session->GetState() != vtkHapticSession::Stopped;
  const palpate::TickHistory& ticks = kept.session->GetRecorder()->GetLastTicks();
  if (kept.run != kept.session->GetNumberOfStarts())
  {
    kept.forget();
    kept.run = kept.session->GetNumberOfStarts();
  }
  kept.follow(kept.session->GetBody(), kept.session->GetResponseName());
  const std::uint64_t oldest = ticks.added() - ticks.size();
  for (std::uint64_t number = std::max(kept.seen, oldest); number < ticks.added(); ++number)
  {
    kept.add(ticks[static_cast<std::size_t>(number - oldest)]);
  }
  kept.seen = ticks.added();
  const palpate::Tick now = runs && ticks.size() > 0 ? ticks[ticks.size() - 1] : palpate::Tick();
  // The error is not reported, because the running session has already reported it.
  std::string error;
  kept.time.show(kept.session->GetRecorder()->GetNumberOfLostTicks());
  kept.way.show(kept.time.now());
  kept.showCurves(now, error);
  if (this->GetHistogramVisibility())
  {
    kept.session->GetRecorder()->GetTimingHistogram(kept.timing);
    kept.histogram.show(kept.timing);
  }
  kept.layOut();
}

void vtkLiveCharts::SetBody(vtkPolyData* body)
{
  this->Kept->body = body;
  this->Modified();
}

void vtkLiveCharts::SetResponseName(const std::string& name)
{
  this->Kept->name = name;
  this->Modified();
}

bool vtkLiveCharts::ShowTip(vtkPolyData* probed, vtkIdType index)
{
  Parts& kept = *this->Kept;
  palpate::Tick now;
  if (!probed || !kept.body || !probed->GetPointData()->HasArray("NormalForce") ||
    !palpate::readTick(probed, index, firstPolyOf(kept.body), now))
  {
    vtkErrorMacro(
      << "Tip " << index
      << " cannot be shown: a body, and a tip of a vtkToolContactProbe's output, are required.");
    return false;
  }
  kept.follow(kept.body, kept.name);
  if (kept.probed != probed || kept.probedTime != probed->GetMTime() || index + 1 < kept.nextTip)
  {
    kept.forget();
    kept.probed = probed;
    kept.probedTime = probed->GetMTime();
  }
  for (; kept.nextTip <= index; ++kept.nextTip)
  {
    palpate::Tick tick;
    palpate::readTick(probed, kept.nextTip, firstPolyOf(kept.body), tick);
    kept.add(tick);
  }
  std::string error;
  kept.time.show(0);
  kept.way.show(kept.time.now());
  kept.showCurves(now, error);
  kept.layOut();
  if (!error.empty())
  {
    vtkErrorMacro(<< "Wrong body: " << error << ".");
    return false;
  }
  return true;
}

bool vtkLiveCharts::ShowTimingHistogram(vtkTable* histogram)
{
  for (const char* name : { "To (us)", "Period", "WakeUp", "Tick" })
  {
    if (!histogram || !vtkDataArray::SafeDownCast(histogram->GetColumnByName(name)))
    {
      vtkErrorMacro(<< "A timing histogram needs a column '" << name << "' of numbers.");
      return false;
    }
  }
  this->Kept->histogram.show(histogram);
  this->Kept->layOut();
  return true;
}

void vtkLiveCharts::AddComparedResponse(const std::string& name, const std::string& label)
{
  this->Kept->compared.emplace_back(name, label);
  this->Kept->known = nullptr;
  this->Modified();
}

void vtkLiveCharts::RemoveAllComparedResponses()
{
  this->Kept->compared.clear();
  this->Kept->known = nullptr;
  this->Modified();
}

void vtkLiveCharts::SetTimeVisibility(bool visible)
{
  this->GetTimeChart()->SetVisible(visible);
  this->Kept->layOut();
}

bool vtkLiveCharts::GetTimeVisibility()
{
  return this->GetTimeChart()->GetVisible();
}

void vtkLiveCharts::SetDeflectionVisibility(bool visible)
{
  this->GetDeflectionChart()->SetVisible(visible);
  this->Kept->layOut();
}

bool vtkLiveCharts::GetDeflectionVisibility()
{
  return this->GetDeflectionChart()->GetVisible();
}

void vtkLiveCharts::SetCurvesVisibility(bool visible)
{
  this->GetCurvesChart()->SetVisible(visible);
  this->Kept->layOut();
}

bool vtkLiveCharts::GetCurvesVisibility()
{
  return this->GetCurvesChart()->GetVisible();
}

void vtkLiveCharts::SetHistogramVisibility(bool visible)
{
  this->GetHistogramChart()->SetVisible(visible);
  this->Kept->layOut();
}

bool vtkLiveCharts::GetHistogramVisibility()
{
  return this->GetHistogramChart()->GetVisible();
}

void vtkLiveCharts::SetDuration(double seconds)
{
  this->Kept->time.setSeconds(std::clamp(seconds, 0.1, 100.0));
  if (this->Kept->session)
  {
    this->SetSession(this->Kept->session);
  }
  this->Modified();
}

double vtkLiveCharts::GetDuration()
{
  return this->Kept->time.seconds();
}

void vtkLiveCharts::SetLargestForce(double force)
{
  this->Kept->largestForce = force;
  this->ResetRanges();
}

double vtkLiveCharts::GetLargestForce()
{
  return this->Kept->largestForce;
}

void vtkLiveCharts::SetLargestDeflection(double deflection)
{
  this->Kept->largestDeflection = deflection;
  this->ResetRanges();
}

double vtkLiveCharts::GetLargestDeflection()
{
  return this->Kept->largestDeflection;
}

void vtkLiveCharts::ResetRanges()
{
  for (const auto& [chart, isVisible] : this->Kept->all())
  {
    chart->reset();
  }
  this->Kept->known = nullptr;
  this->Modified();
}

vtkChartXY* vtkLiveCharts::GetTimeChart()
{
  return this->Kept->time.chart();
}

vtkChartXY* vtkLiveCharts::GetDeflectionChart()
{
  return this->Kept->way.chart();
}

vtkChartXY* vtkLiveCharts::GetCurvesChart()
{
  return this->Kept->curves.chart();
}

vtkChartXY* vtkLiveCharts::GetHistogramChart()
{
  return this->Kept->histogram.chart();
}

void vtkLiveCharts::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Duration: " << this->GetDuration() << " s\n";
  os << indent << "LargestForce: " << this->GetLargestForce() << " N\n";
  os << indent << "LargestDeflection: " << this->GetLargestDeflection() << " mm\n";
  os << indent << "Charts: " << (this->GetTimeVisibility() ? "time " : "")
     << (this->GetDeflectionVisibility() ? "deflection " : "")
     << (this->GetCurvesVisibility() ? "curves " : "")
     << (this->GetHistogramVisibility() ? "histogram" : "") << "\n";
}
