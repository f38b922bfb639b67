// SPDX-License-Identifier: BSD-3-Clause
#ifndef LiveChart_h
#define LiveChart_h

#include "vtkNew.h"

#include <string>
#include <vector>

class vtkChartXY;

namespace palpate
{
/// The look that the charts of a live window have in common: title, two axes, a legend. An axis
/// ends where it was told to, and further on as its values grow; it never shrinks but for reset().
class LiveChart
{
public:
  LiveChart(const char* title, const char* across, const char* up);
  ~LiveChart();
  LiveChart(const LiveChart&) = delete;
  LiveChart& operator=(const LiveChart&) = delete;

  vtkChartXY* chart() { return this->Chart; }
  void setTitle(const std::string& title);

  /// The axes from 0, if they do not go as far yet.
  void growAcross(double largest) { this->grow(AxisAcross, this->EndAcross, largest); }
  void growUp(double largest) { this->grow(AxisUp, this->EndUp, largest); }
  /// Where they end; 0 before the first grow.
  double endAcross() const { return this->EndAcross; }
  double endUp() const { return this->EndUp; }
  /// The next grow begins anew.
  void reset() { this->EndAcross = this->EndUp = 0.0; }

private:
  static constexpr int AxisUp = 0;     // vtkAxis::LEFT
  static constexpr int AxisAcross = 1; // vtkAxis::BOTTOM
  void grow(int axis, double& end, double largest);

  vtkNew<vtkChartXY> Chart;
  double EndAcross = 0.0;
  double EndUp = 0.0;
};

/// Shares out a viewport among charts, row by row from the top left: in so many columns that they
/// become as large as they can at a pleasant shape.
void layOut(const std::vector<vtkChartXY*>& charts, int width, int height);
} // namespace palpate

#endif
