// SPDX-License-Identifier: BSD-3-Clause
// The picture of the curves of three tools at the contact of one of them.
#include "LiveChartPicture.h"
#include "PlacedDevice.h"

int TestLiveChartsTools(int argc, char* argv[])
{
  using namespace palpate::testing;
  const Body body = threeTools();
  LiveChartPicture picture(LiveChartPicture::Curves);
  picture.charts->SetBody(body);
  picture.charts->SetResponseName("Sphere");
  for (const char* name : { "Flat", "Sphere", "Small" })
  {
    picture.charts->AddComparedResponse(name);
  }
  const Body pressed = probed(body, singleTip(0.9, 0.5, -0.8), "Sphere");
  PALPATE_CHECK(picture.charts->ShowTip(pressed, 0));
  const auto sound = draw(picture.window);
  checkBaseline(picture.window, argc, argv);

  picture.charts->RemoveAllComparedResponses();
  for (const char* name : { "Flat", "Small", "Sphere" })
  {
    picture.charts->AddComparedResponse(name);
  }
  PALPATE_CHECK(picture.charts->ShowTip(pressed, 0));
  checkFaultShows("tools exchanged", sound, picture.window);
  picture.charts->RemoveAllComparedResponses();
  PALPATE_CHECK(picture.charts->ShowTip(pressed, 0));
  checkFaultShows("corners instead of tools", sound, picture.window);
  return palpate::testing::result();
}
