// SPDX-License-Identifier: BSD-3-Clause
// Turns ticks into plotted data. vtkLiveCharts.cxx has the settings and decides when to plot.
#include "Interaction/Charts/LiveChartsState.h"

#include "Response/BodyConversion.h"
#include "Interaction/Charts/LiveChart.h"
#include "Interaction/Charts/ResponseReach.h"

#include "vtkChartXY.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace
{
constexpr float CornerWidth = 5.0F;
constexpr float BlendWidth = 3.0F;
constexpr float ComparedWidth = 3.0F;
} // namespace

void vtkLiveCharts::Parts::forget()
{
  this->time.clear();
  this->way.clear();
  this->curves.choose({});
  this->curves.hidePoint();
  this->touched = {};
  this->seen = 0;
  this->nextTip = 0;
}

void vtkLiveCharts::Parts::follow(vtkPolyData* of, const std::string& responseName)
{
  const vtkMTimeType changed = of ? of->GetMTime() : 0;
  if (this->known == of && this->knownTime == changed && this->knownName == responseName)
  {
    return;
  }
  this->known = of;
  this->knownTime = changed;
  this->knownName = responseName;
  this->chooseRanges();
}

void vtkLiveCharts::Parts::chooseRanges()
{
  std::vector<std::string> names{ this->knownName };
  for (const auto& [each, label] : this->compared)
  {
    names.push_back(each);
  }
  const double forced = this->largestForce;
  for (const std::string& each : names)
  {
    const auto reach = palpate::ResponseReach::of(this->known, each, this->largestDeflection);
    this->time.growUp(forced > 0.0 ? forced : reach.halfForce);
    this->way.growUp(forced > 0.0 ? forced : reach.force);
    this->curves.growUp(forced > 0.0 ? forced : reach.force);
    this->way.growAcross(reach.deflection);
    this->curves.growAcross(reach.deflection);
  }
}

void vtkLiveCharts::Parts::add(const palpate::Tick& felt)
{
  const double ideal = felt.idealForce.norm();
  const double applied = felt.appliedForce.norm();
  if (std::isfinite(felt.time))
  {
    this->time.add(felt.time, ideal, applied, felt.contact.friction.norm(), felt.contact.memory);
  }
  const bool touches = felt.contact.triangle >= 0;
  this->way.add(touches, felt.contact.deflection, ideal, applied, ideal - felt.contact.memory);
  this->touched = touches ? felt : this->touched;
}

void vtkLiveCharts::Parts::showCurves(const palpate::Tick& now, std::string& error)
{
  palpate::ContactTriangle place;
  if (this->known &&
    place.find(this->known, this->knownName, this->touched.contact.triangle,
      this->touched.contact.contactPoint))
  {
    if (this->compared.empty())
    {
      this->showCorners(place, error);
    }
    else
    {
      this->showCompared(place, error);
    }
  }
  if (now.contact.triangle >= 0)
  {
    this->curves.showPoint(now.contact.deflection, now.contact.normalForce, now.contact.memory);
  }
  else
  {
    this->curves.hidePoint();
  }
}

void vtkLiveCharts::Parts::showCorners(const palpate::ContactTriangle& place, std::string& error)
{
  const auto response = palpate::ContactResponse::read(this->known, this->knownName, place, error);
  if (!response)
  {
    return;
  }
  std::vector<palpate::ContactCurvesChart::Curve> shown;
  for (int k = 0; k < 3; ++k)
  {
    const double end = response->cornerRange(k);
    shown.push_back(
      { [&response, k](double depth) { return response->cornerForce(k, depth); }, end, end });
  }
  shown.push_back({ [&response](double depth) { return response->force(depth); },
    std::max(response->range(), this->touched.contact.deflection), response->validity() });
  if (response->hasError())
  {
    shown.back().error = [&response](double depth) { return response->error(depth); };
  }
  const auto& colors = palpate::CurveColors;
  std::vector<palpate::ContactCurvesChart::Style> styles{ { "Corner 1", colors[5], CornerWidth },
    { "Corner 2", colors[4], CornerWidth }, { "Corner 3", colors[3], CornerWidth },
    { "Blend", palpate::TextColor, BlendWidth, response->hasError() } };
  if (this->isTilted() && response->hasTilt())
  {
    styles.push_back({ "Tilted", palpate::TorqueColor, BlendWidth });
    shown.push_back({ [&response, tilt = this->touched.contact.tilt](double depth)
      { return response->tiltedForce(depth, tilt); },
      shown.back().end, response->validity() });
  }
  this->curves.choose(styles);
  this->curves.show(shown, this->time.now());
}

void vtkLiveCharts::Parts::showCompared(const palpate::ContactTriangle& place, std::string& error)
{
  std::vector<palpate::ContactCurvesChart::Style> styles;
  std::vector<palpate::ContactCurvesChart::Curve> shown;
  for (const auto& [each, label] : this->compared)
  {
    std::shared_ptr<palpate::ContactResponse> response =
      palpate::ContactResponse::read(this->known, each, place, error);
    if (!response)
    {
      return;
    }
    const std::string tool = palpate::responseText(this->known, each, palpate::ResponseArray::Tool);
    const auto& colors = palpate::CurveColors;
    styles.push_back({ !label.empty() ? label
        : tool.empty()                ? each
                                      : tool,
      colors[styles.size() % colors.size()], ComparedWidth, response->hasError() });
    const double tilt = this->isTilted() ? this->touched.contact.tilt : 0.0;
    shown.push_back({ [response, tilt](double depth)
      { return tilt > 0.0 ? response->tiltedForce(depth, tilt) : response->force(depth); },
      response->range(), response->validity() });
    if (response->hasError())
    {
      shown.back().error = [response](double depth) { return response->error(depth); };
    }
  }
  this->curves.choose(styles);
  this->curves.show(shown, this->time.now());
}

void vtkLiveCharts::Parts::layOut()
{
  if (!this->renderer)
  {
    return;
  }
  std::vector<vtkChartXY*> visible;
  for (const auto& [chart, isVisible] : this->all())
  {
    if (isVisible)
    {
      visible.push_back(chart->chart());
    }
  }
  const int* size = this->renderer->GetSize();
  palpate::layOut(visible, size[0], size[1]);
}
