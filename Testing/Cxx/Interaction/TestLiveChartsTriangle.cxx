// SPDX-License-Identifier: BSD-3-Clause
// The picture of the curves of a triangle's corners, their interpolated curve, which is dotted
// beyond validity, and the running point.
#include "LiveChartPicture.h"

int TestLiveChartsTriangle(int argc, char* argv[])
{
  using namespace palpate::testing;
  const Body body = unevenResponse(planeBody(20.0, 20), "sphere:6.35");
  LiveChartPicture picture(LiveChartPicture::Curves);
  picture.charts->SetBody(body);
  const auto press = [&](double x, double y, double depth)
  { PALPATE_CHECK(picture.charts->ShowTip(probed(body, singleTip(x, y, -depth)), 0)); };
  press(0.9, 0.5, 0.8);
  const auto sound = draw(picture.window);
  checkBaseline(picture.window, argc, argv);

  vtkChartXY* chart = picture.charts->GetCurvesChart();
  for (const char* part : { "Corner 1", "Corner 2", "Corner 3", "Blend", "Now" })
  {
    plotOf(chart, part)->SetVisible(false);
    checkFaultShows(std::string(part) + " is missing", sound, picture.window);
    plotOf(chart, part)->SetVisible(true);
  }
  checkSound(sound, picture.window);
  press(0.9, 0.5, 0.9);
  checkFaultShows("0.1 mm deeper", sound, picture.window);
  press(1.8, 0.3, 0.8);
  checkFaultShows("at another place of the triangle", sound, picture.window);
  press(0.9, 0.5, 0.8);
  checkSound(sound, picture.window);
  return palpate::testing::result();
}
