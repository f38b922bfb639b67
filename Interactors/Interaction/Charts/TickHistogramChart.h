// SPDX-License-Identifier: BSD-3-Clause
#ifndef TickHistogramChart_h
#define TickHistogramChart_h

#include "Interaction/Charts/LiveChart.h"
#include "Interaction/Charts/PlotTable.h"

#include <array>

namespace palpate
{
/// Histograms of the period, wake-up latency and duration of ticks. Both axes are logarithmic.
/// There are ClassesPerDecade classes per decade, beginning at 0.1 us.
class TickHistogramChart : public LiveChart
{
public:
  static constexpr int ClassesPerDecade = 10;
  /// Exponent of the first decade; durations are in microseconds.
  static constexpr int FirstDecade = -1;
  static constexpr int LastDecade = 6;

  TickHistogramChart();

  /// Shows a table of vtkHapticRecorder::GetTimingHistogram. The tables of the plots contain
  /// decimal logarithms, one step per class. An empty class is drawn below the axis.
  void show(vtkTable* histogram);

private:
  void fitAxes(int decades, double largestCount);

  std::array<PlotTable, 3> Stairs; ///< curves of period, wake-up latency and duration
  int DecadesAcross = 0;
  int DecadesUp = 0;
};
} // namespace palpate

#endif
