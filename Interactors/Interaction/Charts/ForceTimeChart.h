// SPDX-License-Identifier: BSD-3-Clause
#ifndef ForceTimeChart_h
#define ForceTimeChart_h

#include "Interaction/Charts/LiveChart.h"
#include "Interaction/Charts/PlotTable.h"
#include "Interaction/Charts/SignalEnvelope.h"

namespace palpate
{
/// Chart of ideal force, applied force, friction and memory force (N) over the last seconds.
/// Applied force, friction and memory force are shown as soon as they occur. A negative memory
/// force is drawn below the axis.
class ForceTimeChart : public LiveChart
{
public:
  explicit ForceTimeChart(double seconds);

  void setSeconds(double seconds);
  double seconds() const { return this->Ideal.signal.seconds(); }
  /// Time of the newest value, s. -inf if there is no value.
  double now() const { return this->Ideal.signal.newest(); }
  void add(double time, double ideal, double applied, double friction, double memory);
  void clear();
  /// Plots the added values. The title contains `lostTicks`, the number of lost ticks.
  void show(long long lostTicks);

private:
  struct Line
  {
    explicit Line(double seconds, const char* name);
    /// Plots the line up to the time `now` (s) and returns its largest value.
    double show(double now);

    SignalEnvelope signal;
    PlotTable table;
  };

  Line Ideal;
  Line Applied;
  Line Friction;
  Line Memory;
  vtkPlot* AppliedPlot;
  vtkPlot* FrictionPlot;
  vtkPlot* MemoryPlot;
  long long LostTicks = 0;
};
} // namespace palpate

#endif
