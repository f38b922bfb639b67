// SPDX-License-Identifier: BSD-3-Clause
// All charts in one viewport: their arrangement in a high and in a wide viewport, and the picture.
#include "LiveChartPicture.h"

#include "vtkRect.h"

#include <array>

namespace
{
using namespace palpate::testing;

/// Checks that the charts are inside the viewport, do not overlap, and have a good aspect ratio.
void checkPlaces(vtkLiveCharts* charts, float width, float height)
{
  const std::array<vtkChartXY*, 4> all = { charts->GetTimeChart(), charts->GetDeflectionChart(),
    charts->GetCurvesChart(), charts->GetHistogramChart() };
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const vtkRectf one = all[i]->GetSize();
    PALPATE_CHECK(!all[i]->GetVisible() ||
      (one.GetLeft() >= 0.0F && one.GetBottom() >= 0.0F && one.GetRight() <= width &&
        one.GetTop() <= height && one.GetWidth() > 150.0F && one.GetHeight() > 150.0F));
    for (std::size_t k = 0; k < i; ++k)
    {
      PALPATE_CHECK(
        !all[i]->GetVisible() || !all[k]->GetVisible() || !one.IntersectsWith(all[k]->GetSize()));
    }
  }
}
} // namespace

int TestLiveChartsWindow(int argc, char* argv[])
{
  const auto session = slidingSession();
  Picture picture(1100, 560);
  vtkSmartPointer<vtkRenderer> scene = picture.addRenderer(0.0, 0.6);
  vtkSmartPointer<vtkRenderer> side = picture.addRenderer(0.6, 1.0);
  vtkNew<vtkLiveCharts> charts;
  charts->SetRenderer(side);
  charts->SetSession(session);
  PALPATE_CHECK(charts->GetRenderer() == side && charts->GetSession() == session);
  PALPATE_CHECK(!side->GetInteractive()); // mouse events are for the scene
  PALPATE_CHECK(session->Start());
  session->Step(1.9);
  charts->Update();
  checkPlaces(charts, 440.0F, 560.0F);
  PALPATE_CHECK(charts->GetTimeChart()->GetSize().GetBottom() >
    charts->GetDeflectionChart()->GetSize().GetTop()); // one above the other
  PALPATE_CHECK(charts->GetDeflectionChart()->GetSize().GetBottom() >
    charts->GetCurvesChart()->GetSize().GetTop());

  picture.window->RemoveRenderer(scene);
  side->SetViewport(0.0, 0.0, 1.0, 1.0);
  charts->SetHistogramVisibility(true);
  charts->Update();
  checkPlaces(charts, 1100.0F, 560.0F); // two rows of two charts
  const auto sound = draw(picture.window);
  checkBaseline(picture.window, argc, argv);
  charts->SetCurvesVisibility(false);
  checkPlaces(charts, 1100.0F, 560.0F);
  checkFaultShows("three charts for four", sound, picture.window);
  charts->SetCurvesVisibility(true);
  charts->Update();
  checkSound(sound, picture.window);

  picture.window->SetSize(1400, 300);
  charts->Update();
  checkPlaces(charts, 1400.0F, 300.0F); // side by side
  PALPATE_CHECK(charts->GetTimeChart()->GetSize().GetRight() <
    charts->GetDeflectionChart()->GetSize().GetLeft());
  PALPATE_CHECK(charts->GetCurvesChart()->GetSize().GetRight() <
    charts->GetHistogramChart()->GetSize().GetLeft());
  charts->SetRenderer(nullptr);
  PALPATE_CHECK(side->GetViewProps()->GetNumberOfItems() == 0);
  return palpate::testing::result();
}
