// SPDX-License-Identifier: BSD-3-Clause
#ifndef ForceDeflectionChart_h
#define ForceDeflectionChart_h

#include "Interaction/Charts/LiveChart.h"
#include "Interaction/Charts/PlotTable.h"

#include <deque>

namespace palpate
{
/**
 * Chart of the ideal and the applied force (N) over the deflection (mm) since the present contact
 * began. If the body relaxes, the slow force at these deflections is also shown; the curve of the
 * ideal force is then a loop around the curve of the slow force.
 *
 * Successive stored points differ in deflection or in a force by at least Resolution, a fraction of
 * the axis. At most LargestCount points are stored; the oldest points are removed.
 */
class ForceDeflectionChart : public LiveChart
{
public:
  static constexpr double Resolution = 1.0 / 400.0;
  static constexpr std::size_t LargestCount = 4000;

  ForceDeflectionChart();

  /// Adds the values of a tick. `slow` is the ideal force without memory.
  void add(bool touches, double deflection, double ideal, double applied, double slow);
  void clear();
  /// Plots the added values, at the time `time` (s).
  void show(double time);

private:
  struct Point
  {
    double deflection = 0.0;
    double ideal = 0.0;
    double applied = 0.0;
    double slow = 0.0;
  };
  bool isNear(const Point& one, const Point& other) const;

  PlotTable Ideal;
  PlotTable Applied;
  PlotTable Slow;
  PlotTable Now;
  vtkPlot* AppliedPlot; ///< visible if a force is applied
  vtkPlot* SlowPlot;    ///< visible if the slow force differs from the ideal force
  /// The last point is that of the newest tick; its distance from the previous point may be smaller
  /// than Resolution.
  std::deque<Point> Path;
  bool Touches = false;
};
} // namespace palpate

#endif
