// SPDX-License-Identifier: BSD-3-Clause
// A window with a live chart of a session that presses and slides.
#ifndef palpate_testing_LiveChartPicture_h
#define palpate_testing_LiveChartPicture_h

#include "LiveChartChecks.h"
#include "Picture.h"

#include "vtkHapticSession.h"

namespace palpate::testing
{
/// A sphere is pressed 1.2 mm into a plane of varying modulus and slides with friction. The device
/// is limited to 10 N.
inline vtkSmartPointer<vtkHapticSession> slidingSession()
{
  auto session = vtkSmartPointer<vtkHapticSession>::New();
  const Body body = unevenResponse(planeBody(20.0, 20), "sphere:6.35");
  session->SetBody(body);
  session->GetSettings()->SetFrictionCoefficient(0.3);
  session->GetDevice()->SetPath(pressAndSlide(1.2));
  return session;
}

/// A window with the size of one chart in a live window.
struct LiveChartPicture : Picture
{
  enum Chart
  {
    Time,
    Deflection,
    Curves,
    Histogram
  };

  explicit LiveChartPicture(Chart shown, int width = 420, int height = 300)
    : Picture(width, height)
  {
    this->charts->SetTimeVisibility(shown == Time);
    this->charts->SetDeflectionVisibility(shown == Deflection);
    this->charts->SetCurvesVisibility(shown == Curves);
    this->charts->SetHistogramVisibility(shown == Histogram);
    this->charts->SetRenderer(this->addRenderer());
  }

  vtkNew<vtkLiveCharts> charts;
};
} // namespace palpate::testing

#endif
