// SPDX-License-Identifier: BSD-3-Clause
// Force over time and over deflection compared with the session's own recording and Sneddon's law;
// axes that only grow; new runs; the histogram compared with the number of ticks.
#include "LiveChartChecks.h"
#include "PlacedDevice.h"

#include "vtkAxis.h"
#include "vtkChartLegend.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <map>
#include <thread>

namespace
{
using namespace palpate::testing;

constexpr double Slope = 2.0 * 3.45 * 1.6; // N/mm: Sneddon's 2 a E* of the flat punch
constexpr double Infinite = std::numeric_limits<double>::infinity();

/// Presses a flat punch 1 mm deep and slides. The device reaches its limit of 10 N at 0.9 mm.
vtkSmartPointer<vtkHapticSession> pressing(vtkPolyData* body)
{
  auto session = vtkSmartPointer<vtkHapticSession>::New();
  session->SetBody(body);
  session->SetResponseName("Flat");
  session->GetSettings()->SetFrictionCoefficient(0.3);
  session->GetDevice()->SetPath(pressAndSlide(1.0));
  return session;
}

struct Recorded
{
  std::vector<Row> ideal; // ideal force over time
  std::vector<Row> applied;
  std::vector<Row> friction;
  std::vector<double> deflection;
  std::vector<bool> touches;
};

Recorded recordedBy(vtkHapticSession* session)
{
  vtkNew<vtkPolyData> recording;
  session->GetRecorder()->GetRecording(recording);
  vtkPointData* data = recording->GetPointData();
  Recorded recorded;
  const auto length = [data](const char* name, vtkIdType i)
  { return vtkMath::Norm(data->GetArray(name)->GetTuple3(i)); };
  for (vtkIdType i = 0; i < recording->GetNumberOfPoints(); ++i)
  {
    const double time = data->GetArray("Time")->GetTuple1(i);
    recorded.ideal.emplace_back(time, length("Force", i));
    recorded.applied.emplace_back(time, length("AppliedForce", i));
    recorded.friction.emplace_back(time, length("FrictionForce", i));
    recorded.deflection.push_back(data->GetArray("Deflection")->GetTuple1(i));
    recorded.touches.push_back(data->GetArray("ContactCell")->GetTuple1(i) >= 0.0);
  }
  return recorded;
}

/// Returns the smallest and the largest value in each interval of 1/500 of `seconds`, by direct
/// search.
std::vector<Row> extremes(const std::vector<Row>& signal, double seconds)
{
  const double now = signal.back().first;
  std::map<double, std::pair<Row, Row>> stretches;
  for (const Row& row : signal)
  {
    const double stretch = std::floor(row.first / (seconds / 500.0));
    const auto [found, isNew] = stretches.emplace(stretch, std::make_pair(row, row));
    auto& [least, largest] = found->second;
    least = row.second < least.second ? row : least;
    largest = row.second > largest.second ? row : largest;
  }
  std::vector<Row> rows;
  for (const auto& [stretch, ends] : stretches)
  {
    const auto [first, second] = std::minmax(ends.first, ends.second);
    for (const Row& row :
      first == second ? std::vector<Row>{ first } : std::vector<Row>{ first, second })
    {
      if (row.first > now - seconds + 1e-6)
      {
        rows.emplace_back(row.first - now, row.second);
      }
    }
  }
  return rows;
}

/// Returns the points of a line, without the first point if its age is exactly `seconds`.
std::vector<Row> within(vtkPlot* plot, double seconds)
{
  std::vector<Row> points = pointsOf(plot);
  if (!points.empty() && points.front().first <= 1e-6 - seconds)
  {
    points.erase(points.begin());
  }
  return points;
}

void checkOverTime(vtkPolyData* body)
{
  for (const double duration : { 0.5, 3.2, 100.0 }) // intervals of 1, 6.4 and 200 ticks
  {
    const auto session = pressing(body);
    vtkNew<vtkLiveCharts> charts;
    charts->SetDuration(duration);
    charts->SetSession(session);
    PALPATE_CHECK(session->GetRecorder()->GetHistorySeconds() == duration && session->Start());
    vtkChartXY* chart = charts->GetTimeChart();
    charts->Update();
    PALPATE_CHECK(pointsOf(plotOf(chart, "Ideal")).empty());
    PALPATE_CHECK(!plotOf(chart, "Friction")->GetVisible());
    double shown = 0.0;
    for (const double seconds : { 0.016, 0.7, 1.3, 0.004, 1.1 })
    {
      session->Step(seconds);
      shown = std::max(shown, chart->GetAxis(vtkAxis::LEFT)->GetMaximum());
      charts->Update();
      const Recorded recorded = recordedBy(session);
      PALPATE_CHECK(within(plotOf(chart, "Ideal"), duration) == extremes(recorded.ideal, duration));
      PALPATE_CHECK(
        within(plotOf(chart, "Applied"), duration) == extremes(recorded.applied, duration));
      PALPATE_CHECK(
        within(plotOf(chart, "Friction"), duration) == extremes(recorded.friction, duration));
      PALPATE_CHECK(chart->GetAxis(vtkAxis::LEFT)->GetMaximum() >= shown);
    }
    PALPATE_CHECK(rowsOf(plotOf(chart, "Ideal")).size() <= 1002); // for any duration and rate
    PALPATE_CHECK(chart->GetAxis(vtkAxis::BOTTOM)->GetMinimum() == -duration);
    PALPATE_CHECK(chart->GetAxis(vtkAxis::BOTTOM)->GetMaximum() == 0.0);
  }
  // The peak by Sneddon's law, 1 mm deep, plus perpendicular friction with a coefficient of 0.3.
  const auto session = pressing(body);
  vtkNew<vtkLiveCharts> charts;
  charts->SetSession(session);
  PALPATE_CHECK(session->Start());
  session->Step(session->GetDevice()->GetPathDuration());
  charts->Update();
  double ideal = 0.0;
  double applied = 0.0;
  for (const auto& [time, force] : pointsOf(plotOf(charts->GetTimeChart(), "Ideal")))
  {
    ideal = std::max(ideal, force);
  }
  for (const auto& [time, force] : pointsOf(plotOf(charts->GetTimeChart(), "Applied")))
  {
    applied = std::max(applied, force);
  }
  PALPATE_CHECK_NEAR(ideal, Slope * std::hypot(1.0, 0.3), 1e-5);
  PALPATE_CHECK_NEAR(applied, 10.0, 1e-12);
  PALPATE_CHECK(plotOf(charts->GetTimeChart(), "Friction")->GetVisible());

  // The next run begins with empty charts.
  PALPATE_CHECK(session->Start());
  charts->Update();
  PALPATE_CHECK(pointsOf(plotOf(charts->GetTimeChart(), "Ideal")).empty());
  PALPATE_CHECK(pointsOf(plotOf(charts->GetDeflectionChart(), "Ideal")).empty());
  PALPATE_CHECK(charts->GetCurvesChart()->GetNumberOfPlots() == 0);
}

/// A pause in a recording is a gap; a slow recording has no gaps.
void checkGaps(vtkPolyData* body)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const Body tips = Body::New();
  tips->SetPoints(points);
  vtkNew<vtkDoubleArray> time;
  time->SetName("Time");
  for (int i = 0; i < 300; ++i)
  {
    points->InsertNextPoint(0.3, 0.2, -0.5 - 0.001 * i);
    time->InsertNextValue(0.01 * i + (i < 200 ? 0.005 : 2.505)); // two values per interval
  }
  tips->GetPointData()->AddArray(time);
  vtkNew<vtkLiveCharts> charts;
  charts->SetBody(body);
  charts->SetResponseName("Flat");
  const Body touched = probed(body, tips, "Flat");
  PALPATE_CHECK(charts->ShowTip(touched, 299));
  const std::vector<Row> rows = rowsOf(plotOf(charts->GetTimeChart(), "Ideal"));
  PALPATE_CHECK(rows.size() == 301);
  PALPATE_CHECK(std::isnan(rows[200].first) && std::isnan(rows[200].second));
  PALPATE_CHECK_NEAR(rows[199].first, 1.99 - 5.49, 1e-12);
  PALPATE_CHECK_NEAR(rows[199].second, 0.699 * Slope, 1e-5);
  // Without an applied force, no applied force is drawn.
  PALPATE_CHECK(!plotOf(charts->GetTimeChart(), "Applied")->GetVisible());
  PALPATE_CHECK(!plotOf(charts->GetDeflectionChart(), "Applied")->GetVisible());

  for (int i = 0; i < 300; ++i)
  {
    time->SetValue(i, 1.0 * i); // values are 1 s apart
  }
  touched->GetPointData()->AddArray(time);
  touched->Modified();
  PALPATE_CHECK(charts->ShowTip(touched, 299));
  const std::vector<Row> slow = rowsOf(plotOf(charts->GetTimeChart(), "Ideal"));
  PALPATE_CHECK(slow.size() == 11 && pointsOf(plotOf(charts->GetTimeChart(), "Ideal")) == slow);
}

/// After a peak has left the chart over time, the axis of the chart shrinks within three seconds,
/// but not before. Legends are outside the data.
void checkShrinking(vtkPolyData* body)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const Body tips = Body::New();
  tips->SetPoints(points);
  vtkNew<vtkDoubleArray> time;
  time->SetName("Time");
  for (int i = 0; i <= 180; ++i)
  {
    points->InsertNextPoint(0.3, 0.2, i < 20 ? -1.0 : -0.05);
    time->InsertNextValue(0.1 * i);
  }
  tips->GetPointData()->AddArray(time);
  vtkNew<vtkLiveCharts> charts;
  charts->SetBody(body);
  charts->SetResponseName("Flat");
  charts->SetLargestForce(0.1); // N; the axis follows the forces from the first tip
  const Body touched = probed(body, tips, "Flat");
  const auto end = [&charts]
  { return charts->GetTimeChart()->GetAxis(vtkAxis::LEFT)->GetMaximum(); };
  for (vtkIdType i = 0; i <= 180; ++i)
  {
    PALPATE_CHECK(charts->ShowTip(touched, i));
    if (i < 148) // the last tip of the peak leaves at 11.9 s
    {
      PALPATE_CHECK(end() >= 1.0 * Slope);
    }
    else if (i > 151)
    {
      // The steps of the axis are 1, 2 or 5 times a power of ten. There are at most five steps.
      PALPATE_CHECK(end() >= 0.05 * Slope && end() < 2.0 * 0.05 * Slope);
    }
  }
  for (vtkChartXY* chart : { charts->GetTimeChart(), charts->GetDeflectionChart(),
         charts->GetCurvesChart(), charts->GetHistogramChart() })
  {
    PALPATE_CHECK(!chart->GetLegend()->GetInline());
  }
}

/// Every tick of the contact is near the line, and every point of the line is a tick.
void checkOverDeflection(vtkPolyData* body)
{
  const auto session = pressing(body);
  session->GetSettings()->SetFrictionCoefficient(0.0);
  vtkNew<vtkLiveCharts> charts;
  charts->SetSession(session);
  PALPATE_CHECK(session->Start());
  vtkChartXY* chart = charts->GetDeflectionChart();
  bool hasTouched = false;
  while (session->GetTime() < session->GetDevice()->GetPathDuration())
  {
    session->Step(0.2);
    charts->Update();
    const Recorded recorded = recordedBy(session);
    const bool touches = recorded.touches.back();
    const std::vector<Row> ideal = pointsOf(plotOf(chart, "Ideal"));
    const std::vector<Row> applied = pointsOf(plotOf(chart, "Applied"));
    PALPATE_CHECK(ideal.size() <= 4000 && (ideal.empty() || touches || hasTouched));
    for (std::size_t i = 0; i < ideal.size(); ++i)
    {
      PALPATE_CHECK_NEAR(ideal[i].second, Slope * ideal[i].first, 1e-5);
      PALPATE_CHECK_NEAR(applied[i].second, std::min(ideal[i].second, 10.0), 1e-12);
      PALPATE_CHECK(std::find(recorded.deflection.begin(), recorded.deflection.end(),
                      ideal[i].first) != recorded.deflection.end());
    }
    const double across = chart->GetAxis(vtkAxis::BOTTOM)->GetMaximum() / 400.0;
    for (std::size_t i = recorded.touches.size(); touches && i-- > 0 && recorded.touches[i];)
    {
      double nearest = Infinite;
      for (const Row& row : ideal)
      {
        nearest = std::min(nearest, std::abs(row.first - recorded.deflection[i]));
      }
      PALPATE_CHECK(nearest <= across);
    }
    const std::vector<Row> now = pointsOf(plotOf(chart, "Now"));
    PALPATE_CHECK(now.size() == (touches ? 1U : 0U));
    PALPATE_CHECK(
      !touches || (now.front() == ideal.back() && now.front().first == recorded.deflection.back()));
    hasTouched = hasTouched || touches;
  }
  PALPATE_CHECK(hasTouched);
}

/// The ranges follow from the responses: 2 mm, and 11.04 N/mm for a punch. The chart over time uses
/// half of the depth.
void checkRanges(vtkPolyData* body)
{
  const Body tip = probed(body, singleTip(0.3, 0.2, -0.1), "Flat");
  vtkNew<vtkLiveCharts> charts;
  charts->SetBody(body);
  charts->SetResponseName("Flat");
  const auto ends = [&charts](double time, double deflection, double force)
  {
    const auto end = [](vtkChartXY* chart, int axis) { return chart->GetAxis(axis)->GetMaximum(); };
    PALPATE_CHECK_NEAR(end(charts->GetTimeChart(), vtkAxis::LEFT), time, 1e-9);
    for (vtkChartXY* chart : { charts->GetDeflectionChart(), charts->GetCurvesChart() })
    {
      PALPATE_CHECK_NEAR(end(chart, vtkAxis::BOTTOM), deflection, 1e-9);
      PALPATE_CHECK_NEAR(end(chart, vtkAxis::LEFT), force, 1e-9);
    }
  };
  PALPATE_CHECK(charts->ShowTip(tip, 0));
  ends(15.0, 2.0, 25.0); // 11.04 N (12.4 N at the sample of 1.125 mm) and 22.08 N, rounded up
  charts->SetLargestForce(60.0);
  charts->SetLargestDeflection(4.0);
  PALPATE_CHECK(charts->ShowTip(tip, 0));
  ends(60.0, 4.0, 60.0);
  charts->SetLargestForce(0.0);
  charts->SetLargestDeflection(0.0);
  PALPATE_CHECK(charts->ShowTip(tip, 0));
  ends(15.0, 2.0, 25.0);
  // For a larger deflection the ranges grow. They do not shrink again.
  PALPATE_CHECK(charts->ShowTip(probed(body, singleTip(0.3, 0.2, -2.6), "Flat"), 0));
  ends(15.0, 3.0, 30.0); // without an array Time there is no force over time
  PALPATE_CHECK(charts->ShowTip(tip, 0));
  ends(15.0, 3.0, 30.0);
  charts->ResetRanges();
  PALPATE_CHECK(charts->ShowTip(tip, 0));
  ends(15.0, 2.0, 25.0);
}

void checkHistogram(vtkPolyData* body)
{
  const auto session = pressing(body);
  session->RealTimeOn();
  session->GetRecorder()->RecordingOff();
  session->GetDevice()->Use(std::make_unique<PlacedDevice>(deviceOf(10.0, 1e6)));
  vtkNew<vtkLiveCharts> charts;
  charts->SetDuration(0.2);
  charts->SetSession(session);
  charts->SetHistogramVisibility(true);
  PALPATE_CHECK(session->Start());
  for (int i = 0; i < 10000 && session->GetNumberOfTicks() < 500; ++i) // at most about 20 s
  {
    // Nothing is read, so some ticks are lost.
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  PALPATE_CHECK(session->GetRecorder()->GetNumberOfLostTicks() > 0);
  session->Stop();
  charts->Update();
  PALPATE_CHECK_TEXT(std::string(charts->GetTimeChart()->GetTitle()),
    (std::to_string(session->GetRecorder()->GetNumberOfLostTicks()) + " ticks lost").c_str());
  const auto ticks = static_cast<double>(session->GetNumberOfTicks());
  for (const auto& [label, expected] : { std::pair<const char*, double>{ "Period", ticks - 1.0 },
         { "Wake-up after deadline", ticks }, { "Tick", ticks } })
  {
    double sum = 0.0;
    const std::vector<Row> stairs = pointsOf(plotOf(charts->GetHistogramChart(), label));
    PALPATE_CHECK(!stairs.empty() && stairs.size() % 2 == 0);
    for (std::size_t i = 0; i + 1 < stairs.size(); i += 2)
    {
      PALPATE_CHECK(stairs[i].second == stairs[i + 1].second);
      PALPATE_CHECK_NEAR(stairs[i + 1].first - stairs[i].first, 0.1, 1e-12);
      sum += stairs[i].second >= 0.0 ? std::pow(10.0, stairs[i].second) : 0.0;
    }
    PALPATE_CHECK_NEAR(sum, expected, 1e-9 * expected);
  }
}

/// Each class is in the tenth of a decade that contains the upper end of the class.
void checkGivenHistogram()
{
  vtkNew<vtkTable> histogram;
  for (const char* name : { "From (us)", "To (us)", "Period", "WakeUp", "Tick" })
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    const bool isTime = std::string(name) == "To (us)";
    for (const double value : isTime ? std::array<double, 4>{ 0.0, 1.25, 1.26, 5e7 }
                                     : std::array<double, 4>{ 1.0, 10.0, 100.0, 0.0 })
    {
      column->InsertNextValue(value);
    }
    histogram->AddColumn(column);
  }
  vtkNew<vtkLiveCharts> charts;
  PALPATE_CHECK(charts->ShowTimingHistogram(histogram));
  const std::vector<Row> stairs = pointsOf(plotOf(charts->GetHistogramChart(), "Tick"));
  PALPATE_CHECK(stairs.size() == 140); // ten per decade, 0.1 us to 1 s
  for (std::size_t i = 0; i < stairs.size(); i += 2)
  {
    const double height = i == 0 ? 0.0 : i == 20 ? 1.0 : i == 22 ? 2.0 : -0.6; // 10^0.1 = 1.2589
    PALPATE_CHECK_NEAR(stairs[i].first, -1.0 + 0.05 * static_cast<double>(i), 1e-12);
    PALPATE_CHECK_NEAR(stairs[i].second, height, 1e-12);
  }
  Messages messages(charts);
  histogram->RemoveColumnByName("WakeUp");
  PALPATE_CHECK(!charts->ShowTimingHistogram(histogram));
  PALPATE_CHECK_TEXT(messages.takeErrors(), "WakeUp");
  PALPATE_CHECK(!charts->ShowTimingHistogram(nullptr));
  PALPATE_CHECK_TEXT(messages.takeErrors(), "To (us)");
}

void checkErrors(vtkPolyData* body)
{
  vtkNew<vtkLiveCharts> charts;
  Messages messages(charts);
  charts->Update(); // no effect without a session
  PALPATE_CHECK(messages.none());
  const Body tip = singleTip(0.3, 0.2, -0.1);
  const Body touched = probed(body, tip, "Flat");
  PALPATE_CHECK(!charts->ShowTip(touched, 0));
  PALPATE_CHECK_TEXT(messages.takeErrors(), "body");
  charts->SetBody(body);
  PALPATE_CHECK(!charts->ShowTip(nullptr, 0) && !charts->ShowTip(tip, 0));
  PALPATE_CHECK(!charts->ShowTip(touched, 1) && !charts->ShowTip(touched, -1));
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Tip 1", "Probe");
  charts->SetResponseName("Steep");
  PALPATE_CHECK(!charts->ShowTip(touched, 0));
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Steep");
  charts->SetDuration(0.0);
  PALPATE_CHECK(charts->GetDuration() == 0.1);
  charts->SetDuration(1e9);
  PALPATE_CHECK(charts->GetDuration() == 100.0);
}
} // namespace

int TestLiveCharts(int, char*[])
{
  const Body body = threeTools();
  checkOverTime(body);
  checkGaps(body);
  checkShrinking(body);
  checkOverDeflection(body);
  checkRanges(body);
  checkHistogram(body);
  checkGivenHistogram();
  checkErrors(body);
  return palpate::testing::result();
}
