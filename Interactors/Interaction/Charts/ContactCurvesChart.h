// SPDX-License-Identifier: BSD-3-Clause
#ifndef ContactCurvesChart_h
#define ContactCurvesChart_h

#include "Interaction/Charts/LiveChart.h"
#include "Interaction/Charts/PlotTable.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// Chart of force (N) over deflection (mm) for several curves at a contact. The curves are dotted
/// beyond validity, and a curve may have an error band. A running point shows the present force. On
/// a body that relaxes, a vertical line at the running point shows the memory part of the force.
class ContactCurvesChart : public LiveChart
{
public:
  static constexpr int Steps = 60; ///< number of intervals of a plotted curve

  /// The style of a curve.
  struct Style
  {
    std::string label;
    Color color;
    float width;
    bool hasBand = false;

    bool operator==(const Style& other) const
    {
      return this->label == other.label && this->color == other.color &&
        this->width == other.width && this->hasBand == other.hasBand;
    }
  };
  /// The values of a curve, as functions of the deflection.
  struct Curve
  {
    /// Force in N at a deflection in mm; NaN if there is no value.
    std::function<double(double)> force;
    double end = 0.0;      ///< largest plotted deflection, mm
    double validity = 0.0; ///< mm
    /// Relative error at a deflection in mm; null for a curve without a band.
    std::function<double(double)> error = {};
  };

  ContactCurvesChart();

  /// Sets the styles, one per curve. Has no effect if the styles are unchanged.
  void choose(const std::vector<Style>& styles);
  /// Shows the curves, one per style, at the time `time` (s).
  void show(const std::vector<Curve>& curves, double time);
  /// Sets or hides the running point. `deflection` is in mm and `force` in N. `memory` is the part
  /// of the force above the slow force, N.
  void showPoint(double deflection, double force, double memory);
  void hidePoint();

private:
  struct Line
  {
    explicit Line(const std::string& label);
    void show(const Curve& curve);

    PlotTable trusted; ///< the part of the curve up to validity
    PlotTable beyond;
    BandTable band;
  };

  std::vector<Style> Styles;
  std::vector<std::unique_ptr<Line>> Lines;
  PlotTable Memory;
  vtkPlot* MemoryPlot = nullptr; ///< owned by the chart; null if there are no curves
  PlotTable Now;
};
} // namespace palpate

#endif
