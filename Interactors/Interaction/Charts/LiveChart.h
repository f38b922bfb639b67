// SPDX-License-Identifier: BSD-3-Clause
#ifndef LiveChart_h
#define LiveChart_h

#include "Interaction/Display/ScaleRule.h"

#include "vtkNew.h"

#include <string>
#include <vector>

class vtkChartXY;

namespace palpate
{
/// Base class of the charts of a live window. A chart has a title, two axes, and a legend outside
/// the data. The ends of the axes follow the drawn values (ScaleRule).
class LiveChart
{
public:
  LiveChart(const char* title, const char* across, const char* up);
  ~LiveChart();
  LiveChart(const LiveChart&) = delete;
  LiveChart& operator=(const LiveChart&) = delete;

  vtkChartXY* chart() { return this->Chart; }
  void setTitle(const std::string& title);

  /// Extend an axis, which starts at 0, if its end is below `largest`.
  void growAcross(double largest) { this->grow(AxisAcross, this->EndAcross, largest); }
  void growUp(double largest) { this->grow(AxisUp, this->EndUp, largest); }
  /// Fit the end of an axis to the largest value that is drawn at the time `time` (s).
  void fitAcross(double largest, double time)
  {
    this->fit(AxisAcross, this->EndAcross, this->RuleAcross, largest, time);
  }
  void fitUp(double largest, double time)
  {
    this->fit(AxisUp, this->EndUp, this->RuleUp, largest, time);
  }
  /// Ends of the axes. They are 0 before the first call of growAcross() or growUp().
  double endAcross() const { return this->EndAcross; }
  double endUp() const { return this->EndUp; }
  /// Resets both ends to 0. The axes then grow again.
  void reset() { this->EndAcross = this->EndUp = 0.0; }

private:
  static constexpr int AxisUp = 0;     // vtkAxis::LEFT
  static constexpr int AxisAcross = 1; // vtkAxis::BOTTOM
  void grow(int axis, double& end, double largest);
  void fit(int axis, double& end, ScaleRule& rule, double largest, double time);

  vtkNew<vtkChartXY> Chart;
  double EndAcross = 0.0;
  double EndUp = 0.0;
  ScaleRule RuleAcross;
  ScaleRule RuleUp;
};

/// Divides a viewport among charts, row by row from the top left. The number of columns is chosen
/// so that the charts are as large as possible with a good ratio of width to height. The legend is
/// to the right of the data if it is narrow, otherwise above the data.
void layOut(const std::vector<vtkChartXY*>& charts, int width, int height);
} // namespace palpate

#endif
