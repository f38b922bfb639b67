// SPDX-License-Identifier: BSD-3-Clause
// The picture of force over deflection for a contact: a press and a slide, with ideal and applied
// force.
#include "LiveChartPicture.h"

int TestLiveChartsDeflection(int argc, char* argv[])
{
  using namespace palpate::testing;
  const auto session = slidingSession();
  LiveChartPicture picture(LiveChartPicture::Deflection);
  picture.charts->SetSession(session);
  PALPATE_CHECK(session->Start());
  session->Step(1.9);
  picture.charts->Update();
  const auto sound = draw(picture.window);
  checkBaseline(picture.window, argc, argv);

  vtkChartXY* chart = picture.charts->GetDeflectionChart();
  for (const char* part : { "Ideal", "Applied", "Now" })
  {
    plotOf(chart, part)->SetVisible(false);
    checkFaultShows(std::string(part) + " is missing", sound, picture.window);
    plotOf(chart, part)->SetVisible(true);
  }
  checkSound(sound, picture.window);
  session->Step(1.0); // the tool lifts off
  picture.charts->Update();
  checkFaultShows("the tool has left", sound, picture.window);
  return palpate::testing::result();
}
