// SPDX-License-Identifier: BSD-3-Clause
// The picture of force over time: ideal, applied and friction force in a press that exceeds the
// device's force.
#include "LiveChartPicture.h"

#include "vtkAxis.h"

int TestLiveChartsTime(int argc, char* argv[])
{
  using namespace palpate::testing;
  const auto session = slidingSession();
  LiveChartPicture picture(LiveChartPicture::Time);
  picture.charts->SetDuration(4.0);
  picture.charts->SetSession(session);
  PALPATE_CHECK(session->Start());
  session->Step(2.8);
  picture.charts->Update();
  const auto sound = draw(picture.window);
  checkBaseline(picture.window, argc, argv);

  vtkChartXY* chart = picture.charts->GetTimeChart();
  for (const char* line : { "Ideal", "Applied", "Friction" })
  {
    plotOf(chart, line)->SetVisible(false);
    checkFaultShows(std::string(line) + " is missing", sound, picture.window);
    plotOf(chart, line)->SetVisible(true);
  }
  checkSound(sound, picture.window);
  chart->GetAxis(vtkAxis::LEFT)->SetTitle("Force (mN)");
  checkFaultShows("another unit at the axis", sound, picture.window);
  chart->GetAxis(vtkAxis::LEFT)->SetTitle("Force (N)");
  session->Step(0.1);
  checkSound(sound, picture.window); // only Update adds new ticks
  picture.charts->Update();
  checkFaultShows("a tenth of a second later", sound, picture.window);
  return palpate::testing::result();
}
