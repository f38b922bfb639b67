// SPDX-License-Identifier: BSD-3-Clause
#ifndef ForceDeflectionChart_h
#define ForceDeflectionChart_h

#include "Interaction/Charts/LiveChart.h"
#include "Interaction/Charts/PlotTable.h"

#include <deque>

namespace palpate
{
/**
 * Ideal and applied force (N) over the deflection (mm) since the last first contact, and, if the
 * body relaxes, the slow force at these depths, around which the ideal one makes a loop.
 *
 * The path is kept in points that are Resolution of an axis apart, in deflection or a force; of
 * more than LargestCount points the last ones.
 */
class ForceDeflectionChart : public LiveChart
{
public:
  static constexpr double Resolution = 1.0 / 400.0;
  static constexpr std::size_t LargestCount = 4000;

  ForceDeflectionChart();

  /// `slow`: the ideal force without memory.
  void add(bool touches, double deflection, double ideal, double applied, double slow);
  void clear();
  void show();

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
  vtkPlot* AppliedPlot;  ///< visible if a force is applied
  vtkPlot* SlowPlot;     ///< visible if it differs from the ideal one
  std::deque<Point> Way; ///< the last point is the newest, at any distance
  bool Touches = false;
  double LargestDeflection = 0.0;
  double LargestForce = 0.0;
};
} // namespace palpate

#endif
