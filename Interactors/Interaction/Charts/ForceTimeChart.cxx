// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Charts/ForceTimeChart.h"

#include "Interaction/Charts/ChartStyle.h"

#include "vtkAxis.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace palpate
{
namespace
{
constexpr const char* Title = "Force over time";
constexpr const char* TimeName = "Time before now (s)";
// Each bin has one or two points. With this number of bins a curve has more points than a chart of
// this kind has pixels.
constexpr std::size_t Bins = 500;
constexpr int TimeSteps = 5;
} // namespace

ForceTimeChart::Line::Line(double seconds, const char* name)
  : signal(seconds, Bins)
  , table(TimeName, name)
{
}

double ForceTimeChart::Line::show(double now)
{
  double largest = 0.0;
  this->table.begin();
  this->signal.visit(
    now,
    [&](double time, double value)
    {
      this->table.add(time - now, value);
      largest = std::max(largest, value);
    },
    [this]() { this->table.addGap(); });
  this->table.end();
  return largest;
}

ForceTimeChart::ForceTimeChart(double seconds)
  : LiveChart(Title, TimeName, "Force (N)")
  , Ideal(seconds, "Ideal force (N)")
  , Applied(seconds, "Applied force (N)")
  , Friction(seconds, "Friction (N)")
  , Memory(seconds, "Memory (N)")
{
  // The applied force is drawn over the ideal force. The line of the ideal force is wider, so that
  // its edges remain visible.
  this->Ideal.table.addLine(this->chart(), "Ideal", ForceColor, 4.0F);
  this->AppliedPlot =
    this->Applied.table.addLine(this->chart(), "Applied", AppliedForceColor, 2.0F);
  this->FrictionPlot =
    this->Friction.table.addLine(this->chart(), "Friction", FrictionForceColor, 2.0F);
  this->MemoryPlot = this->Memory.table.addLine(this->chart(), "Memory", MemoryForceColor, 2.0F);
  this->setSeconds(seconds);
}

void ForceTimeChart::setSeconds(double seconds)
{
  for (Line* line : { &this->Ideal, &this->Applied, &this->Friction, &this->Memory })
  {
    line->signal = SignalEnvelope(seconds, Bins);
  }
  fitAxisBefore(this->chart()->GetAxis(vtkAxis::BOTTOM), seconds, TimeSteps);
  this->clear();
}

void ForceTimeChart::add(double time, double ideal, double applied, double friction, double memory)
{
  this->Ideal.signal.add(time, ideal);
  this->Applied.signal.add(time, applied);
  this->Friction.signal.add(time, friction);
  this->Memory.signal.add(time, memory);
  if (std::isfinite(applied))
  {
    this->AppliedPlot->SetVisible(true);
  }
  if (friction > 0.0)
  {
    this->FrictionPlot->SetVisible(true);
  }
  if (memory != 0.0)
  {
    this->MemoryPlot->SetVisible(true);
  }
}

void ForceTimeChart::clear()
{
  for (Line* line : { &this->Ideal, &this->Applied, &this->Friction, &this->Memory })
  {
    line->signal.clear();
    line->show(0.0);
  }
  this->AppliedPlot->SetVisible(false);
  this->FrictionPlot->SetVisible(false);
  this->MemoryPlot->SetVisible(false);
}

void ForceTimeChart::show(long long lostTicks)
{
  const double now = this->Ideal.signal.newest();
  double largest = 0.0;
  for (Line* line : { &this->Ideal, &this->Applied, &this->Friction, &this->Memory })
  {
    largest = std::max(largest, line->show(now));
  }
  this->fitUp(largest, now);
  if (lostTicks != this->LostTicks)
  {
    this->LostTicks = lostTicks;
    const std::string lost = " (" + std::to_string(lostTicks) + " ticks lost)";
    this->setTitle(Title + (lostTicks > 0 ? lost : std::string()));
  }
}
} // namespace palpate
