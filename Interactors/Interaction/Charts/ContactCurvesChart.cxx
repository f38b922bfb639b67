// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Charts/ContactCurvesChart.h"

#include "Interaction/Charts/ChartStyle.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr const char* DeflectionName = "Deflection (mm)";
} // namespace

ContactCurvesChart::Line::Line(const std::string& label)
  : trusted(DeflectionName, (label + " (N)").c_str())
  , beyond(DeflectionName, (label + " beyond validity (N)").c_str())
  , band(DeflectionName, (label + ", least (N)").c_str(), (label + ", most (N)").c_str())
{
}

void ContactCurvesChart::Line::show(const Curve& curve)
{
  const double join = std::clamp(curve.validity, 0.0, curve.end);
  this->trusted.begin();
  this->beyond.begin();
  this->band.begin();
  for (int i = 0; std::isfinite(curve.end) && i <= Steps; ++i)
  {
    const double depth = curve.end * i / Steps;
    const double before = curve.end * (i - 1) / Steps;
    const double error = curve.error ? std::min(curve.error(depth), 1.0) : 0.0;
    if (curve.error && std::isfinite(error))
    {
      const double force = curve.force(depth);
      this->band.add(depth, (1.0 - error) * force, (1.0 + error) * force);
    }
    // Both parts of the curve contain the point where the parts join.
    if (before < join && join < depth)
    {
      this->trusted.add(join, curve.force(join));
      this->beyond.add(join, curve.force(join));
    }
    if (depth <= join && join > 0.0) // a single point would be no line
    {
      this->trusted.add(depth, curve.force(depth));
    }
    if (depth >= join && join < curve.end)
    {
      this->beyond.add(depth, curve.force(depth));
    }
  }
  this->trusted.end();
  this->beyond.end();
  this->band.end();
}

ContactCurvesChart::ContactCurvesChart()
  : LiveChart("Curves at the contact", DeflectionName, "Normal force (N)")
  , Memory(DeflectionName, "Memory (N)")
  , Now(DeflectionName, "Normal force now (N)")
{
}

void ContactCurvesChart::choose(const std::vector<Style>& styles)
{
  if (styles == this->Styles)
  {
    return;
  }
  this->Styles = styles;
  this->chart()->ClearPlots();
  this->Lines.clear();
  this->MemoryPlot = nullptr;
  bool hasBand = false; // so that the legend has only one entry for all bands
  for (const Style& style : styles)
  {
    auto line = std::make_unique<Line>(style.label);
    if (style.hasBand)
    {
      addBand(this->chart(), line->band.table(), style.color, hasBand ? "" : BandLabel);
      hasBand = true;
    }
    line->trusted.addLine(this->chart(), style.label, style.color, style.width);
    line->beyond.addLine(this->chart(), "", style.color, style.width, vtkPen::DOT_LINE);
    this->Lines.push_back(std::move(line));
  }
  if (!styles.empty())
  {
    this->MemoryPlot = this->Memory.addLine(this->chart(), "Memory", MemoryForceColor, 3.0F);
    this->MemoryPlot->SetVisible(false);
    this->Now.addMarker(this->chart(), "Now", ForceColor, 11.0F);
  }
}

void ContactCurvesChart::show(const std::vector<Curve>& curves, double time)
{
  double deepest = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < std::min(curves.size(), this->Lines.size()); ++i)
  {
    this->Lines[i]->show(curves[i]);
    const double force = curves[i].force(curves[i].end);
    deepest = std::isfinite(curves[i].end) ? std::max(deepest, curves[i].end) : deepest;
    largest = std::isfinite(force) ? std::max(largest, force) : largest;
  }
  this->fitAcross(deepest, time);
  this->fitUp(largest, time);
}

void ContactCurvesChart::showPoint(double deflection, double force, double memory)
{
  this->growAcross(deflection);
  this->growUp(std::max(force, force - memory));
  this->Memory.begin();
  if (memory != 0.0)
  {
    this->Memory.add(deflection, force - memory);
    this->Memory.add(deflection, force);
  }
  this->Memory.end();
  if (this->MemoryPlot)
  {
    this->MemoryPlot->SetVisible(memory != 0.0);
  }
  this->Now.begin();
  this->Now.add(deflection, force);
  this->Now.end();
}

void ContactCurvesChart::hidePoint()
{
  this->Memory.begin();
  this->Memory.end();
  this->Now.begin();
  this->Now.end();
}
} // namespace palpate
