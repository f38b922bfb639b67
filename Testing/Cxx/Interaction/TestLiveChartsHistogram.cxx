// SPDX-License-Identifier: BSD-3-Clause
// The picture of the tick histogram for synthetic times: 1 kHz, wake-up about 20 us late, ticks of
// 1 us.
#include "LiveChartPicture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
/// A peak of about `ticks` ticks around `middle` us, `width` decades wide, with a tail of outliers.
double count(double time, double middle, double width, double ticks)
{
  const double away = std::log10(time / middle) / width;
  return std::floor(ticks * std::exp(-away * away) / (1.0 + away * away));
}
} // namespace

int TestLiveChartsHistogram(int argc, char* argv[])
{
  using namespace palpate::testing;
  const std::array<const char*, 5> names = { "From (us)", "To (us)", "Period", "WakeUp", "Tick" };
  vtkNew<vtkTable> histogram;
  std::array<vtkNew<vtkDoubleArray>, 5> columns;
  for (int i = 0; i < 400; ++i)
  {
    const double time = std::pow(10.0, -0.5 + 0.0125 * i); // 0.3 us to 30 ms
    columns[0]->InsertNextValue(time * std::pow(10.0, -0.0125));
    columns[1]->InsertNextValue(time);
    columns[2]->InsertNextValue(count(time, 1000.0, 0.04, 20000.0));
    columns[3]->InsertNextValue(count(time, 18.0, 0.25, 2000.0));
    columns[4]->InsertNextValue(count(time, 1.3, 0.15, 4000.0));
  }
  for (std::size_t k = 0; k < names.size(); ++k)
  {
    columns[k]->SetName(names[k]);
    histogram->AddColumn(columns[k]);
  }
  LiveChartPicture picture(LiveChartPicture::Histogram);
  PALPATE_CHECK(picture.charts->ShowTimingHistogram(histogram));
  const auto sound = draw(picture.window);
  checkBaseline(picture.window, argc, argv);

  for (const char* part : { "Period", "Wake-up after deadline", "Tick" })
  {
    plotOf(picture.charts->GetHistogramChart(), part)->SetVisible(false);
    checkFaultShows(std::string(part) + " is missing", sound, picture.window);
    plotOf(picture.charts->GetHistogramChart(), part)->SetVisible(true);
  }
  checkSound(sound, picture.window);
  columns[3]->SetValue(360, 3.0); // three ticks 10 ms late
  PALPATE_CHECK(picture.charts->ShowTimingHistogram(histogram));
  checkFaultShows("three stragglers", sound, picture.window);
  return palpate::testing::result();
}
