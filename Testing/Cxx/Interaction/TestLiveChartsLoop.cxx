// SPDX-License-Identifier: BSD-3-Clause
// The picture of the force loop of a press on liver, drawn during the press, and the numbers of the
// loop in both charts.
#include "LiveChartPicture.h"
#include "LiverSlab.h"

namespace
{
using namespace palpate::testing;

void checkNumbers(vtkLiveCharts* charts)
{
  const auto felt = pointsOf(plotOf(charts->GetDeflectionChart(), "Ideal"));
  const auto slow = pointsOf(plotOf(charts->GetDeflectionChart(), "Slow"));
  checkLoop(Loop(felt), Loop(slow), 1.514, 0.2434);
  double most = 0.0;
  for (const Row& row : pointsOf(plotOf(charts->GetTimeChart(), "Memory")))
  {
    most = std::max(most, row.second);
  }
  // The deepest tick has the largest memory, because depth and memory both increase up to this
  // tick.
  PALPATE_CHECK_NEAR(most / Loop(felt).peak, 1.0 - 1.0 / 1.514, 0.005);
}

void checkStill()
{
  const auto session = slabSession(liverSlab(6.35, false));
  vtkNew<vtkLiveCharts> charts;
  charts->SetSession(session);
  PALPATE_CHECK(session->Start());
  session->Step(SlabDuration);
  charts->Update();
  PALPATE_CHECK(!plotOf(charts->GetDeflectionChart(), "Slow")->GetVisible());
  PALPATE_CHECK(!plotOf(charts->GetTimeChart(), "Memory")->GetVisible());
}
} // namespace

int TestLiveChartsLoop(int argc, char* argv[])
{
  checkStill();
  const auto session = slabSession(liverSlab(6.35));
  LiveChartPicture picture(LiveChartPicture::Deflection);
  picture.charts->SetDuration(SlabDuration);
  picture.charts->SetSession(session);
  PALPATE_CHECK(session->Start());
  session->Step(SlabDuration - 2.0);
  picture.charts->Update();
  const auto sound = draw(picture.window);
  checkBaseline(picture.window, argc, argv);

  vtkChartXY* chart = picture.charts->GetDeflectionChart();
  for (const char* part : { "Slow", "Ideal", "Applied", "Now" })
  {
    plotOf(chart, part)->SetVisible(false);
    checkFaultShows(std::string(part) + " is missing", sound, picture.window);
    plotOf(chart, part)->SetVisible(true);
  }
  checkSound(sound, picture.window);
  session->Step(2.0);
  picture.charts->Update();
  checkNumbers(picture.charts);
  return result();
}
