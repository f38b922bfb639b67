// SPDX-License-Identifier: BSD-3-Clause
// Private parts of vtkLiveCharts.
#ifndef LiveChartsState_h
#define LiveChartsState_h

#include "Interaction/Charts/ContactCurvesChart.h"
#include "Interaction/Charts/ContactResponse.h"
#include "Interaction/Charts/ForceDeflectionChart.h"
#include "Interaction/Charts/ForceTimeChart.h"
#include "Interaction/Charts/TickHistogramChart.h"
#include "Haptics/Servo/ServoStep.h"
#include "vtkHapticSession.h"
#include "vtkLiveCharts.h"

#include "vtkContextActor.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

struct vtkLiveCharts::Parts
{
  palpate::ForceTimeChart time{ 10.0 };
  palpate::ForceDeflectionChart way;
  palpate::ContactCurvesChart curves;
  palpate::TickHistogramChart histogram;
  vtkNew<vtkContextActor> actor;
  vtkNew<vtkTable> timing;

  vtkSmartPointer<vtkRenderer> renderer;
  vtkSmartPointer<vtkHapticSession> session;
  vtkSmartPointer<vtkPolyData> body; // body for ShowTip
  std::string name = "Response";
  // Prefixes and labels of the compared responses.
  std::vector<std::pair<std::string, std::string>> compared;

  double largestForce = 0.0;
  double largestDeflection = 0.0;

  // The body, its modification time and the response for which the ranges and curves were made.
  vtkSmartPointer<vtkPolyData> known;
  vtkMTimeType knownTime = 0;
  std::string knownName;

  // The session's run with the number of its ticks that have been read, and the same for the points
  // of a recording.
  vtkIdType run = 0;
  std::uint64_t seen = 0;
  vtkSmartPointer<vtkPolyData> probed;
  vtkMTimeType probedTime = 0;
  vtkIdType nextTip = 0;
  palpate::Tick touched; ///< tick of the newest contact

  // Charts in display order, with their visibility.
  std::vector<std::pair<palpate::LiveChart*, bool>> all()
  {
    return { { &this->time, this->time.chart()->GetVisible() },
      { &this->way, this->way.chart()->GetVisible() },
      { &this->curves, this->curves.chart()->GetVisible() },
      { &this->histogram, this->histogram.chart()->GetVisible() } };
  }

  /// Clears the forces but keeps the ranges of the axes.
  void forget();
  /// Changes to the response `responseName` of a body, if body or response differ from the present
  /// ones.
  void follow(vtkPolyData* of, const std::string& responseName);
  void chooseRanges();
  /// Whether the newest contact is tilted so much that its curve visibly differs from that of an
  /// upright tool.
  bool isTilted() const
  {
    constexpr double upright = 1e-3; // smallest visible tilt, rad; as in the caption
    return this->touched.contact.tilt > upright;
  }
  void add(const palpate::Tick& felt);
  void showCurves(const palpate::Tick& now, std::string& error);
  void showCorners(const palpate::ContactTriangle& place, std::string& error);
  void showCompared(const palpate::ContactTriangle& place, std::string& error);
  void layOut();
};

#endif
