// SPDX-License-Identifier: BSD-3-Clause
#ifndef ForceDeflectionChart_h
#define ForceDeflectionChart_h

#include "Interaction/Charts/LiveChart.h"
#include "Interaction/Charts/PlotTable.h"

#include <deque>

namespace palpate
{
/**
 * Chart of the ideal and the applied force (N) over the deflection (mm), since the last beginning
 * of a contact. If the body relaxes, the slow force at these deflections is shown, too; the curve
 * of the ideal force is a loop around it.
 *
 * Successive stored points differ in deflection, or in a force, by at least the fraction Resolution
 * of the axis. At most LargestCount points are stored; the oldest are removed.
 */
class ForceDeflectionChart : public LiveChart
{
public:
  static constexpr double Resolution = 1.0 / 400.0;
  static constexpr std::size_t LargestCount = 4000;

  ForceDeflectionChart();

  /// Adds a tick. `slow` is the ideal force without memory.
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
  /// The last point is the newest tick; it may be closer to the previous point than Resolution.
  std::deque<Point> Path;
  bool Touches = false;
};
} // namespace palpate

#endif
