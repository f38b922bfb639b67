// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Charts/TickHistogramChart.h"

#include "Interaction/Charts/ChartStyle.h"

#include "vtkAxis.h"
#include "vtkChartLegend.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr const char* Names[3] = { "Period", "WakeUp", "Tick" };
constexpr const char* Labels[3] = { "Period", "Wake-up after deadline", "Tick" };
constexpr float Widths[3] = { 4.0F, 2.0F, 2.0F };
constexpr int Classes = TickHistogramChart::ClassesPerDecade *
  (TickHistogramChart::LastDecade - TickHistogramChart::FirstDecade);
constexpr double EmptyClassDepth =
  0.3; // fraction of a decade by which empty classes are drawn below the axis

using Counts = std::array<double, Classes>;

/// Returns the index of the class that contains a duration. Shorter durations belong to the first
/// class, longer ones to the last class.
int classOf(double microseconds)
{
  const double decades = std::log10(microseconds) - TickHistogramChart::FirstDecade;
  const double index = std::ceil(TickHistogramChart::ClassesPerDecade * decades) - 1.0;
  return index > 0.0 ? static_cast<int>(std::min(index, Classes - 1.0)) : 0;
}

double leftOf(int index)
{
  return TickHistogramChart::FirstDecade +
    static_cast<double>(index) / TickHistogramChart::ClassesPerDecade;
}

Counts countsOf(vtkTable* histogram, const char* name)
{
  Counts counts{};
  vtkDataArray* upTo = vtkDataArray::SafeDownCast(histogram->GetColumnByName("To (us)"));
  vtkDataArray* column = vtkDataArray::SafeDownCast(histogram->GetColumnByName(name));
  for (vtkIdType row = 0; upTo && column && row < histogram->GetNumberOfRows(); ++row)
  {
    counts[static_cast<std::size_t>(classOf(upTo->GetTuple1(row)))] += column->GetTuple1(row);
  }
  return counts;
}

double heightOf(double count)
{
  return count > 0.0 ? std::log10(count) : -2.0 * EmptyClassDepth;
}
} // namespace

TickHistogramChart::TickHistogramChart()
  : LiveChart("Ticks of the servo thread", "Time (µs)", "Ticks")
  , Stairs{ PlotTable("log10 time (us)", "log10 period"),
    PlotTable("log10 time (us)", "log10 wake-up"), PlotTable("log10 time (us)", "log10 tick") }
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    this->Stairs[k].addLine(this->chart(), Labels[k], CurveColors[k], Widths[k]);
  }
  this->fitAxes(4 - FirstDecade, 1000.0);
}

void TickHistogramChart::fitAxes(int decades, double largestCount)
{
  if (decades > this->DecadesAcross)
  {
    this->DecadesAcross = decades;
    fitLogAxis(this->chart()->GetAxis(vtkAxis::BOTTOM), FirstDecade, FirstDecade + decades);
  }
  // The axis extends one decade above the largest count, so that the legend has space.
  const int high = 1 + static_cast<int>(std::ceil(std::log10(std::max(largestCount, 1.0))));
  if (high > this->DecadesUp)
  {
    this->DecadesUp = high;
    fitLogAxis(this->chart()->GetAxis(vtkAxis::LEFT), 0, high, EmptyClassDepth);
  }
}

void TickHistogramChart::show(vtkTable* histogram)
{
  int last = -1;
  double largest = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Counts counts = countsOf(histogram, Names[k]);
    PlotTable& stairs = this->Stairs[k];
    stairs.begin();
    for (int i = 0; i < Classes && histogram->GetNumberOfRows() > 0; ++i)
    {
      const double count = counts[static_cast<std::size_t>(i)];
      stairs.add(leftOf(i), heightOf(count));
      stairs.add(leftOf(i + 1), heightOf(count));
      last = count > 0.0 ? std::max(last, i) : last;
      largest = std::max(largest, count);
    }
    stairs.end();
  }
  this->fitAxes((last + ClassesPerDecade) / ClassesPerDecade, largest);
}
} // namespace palpate
