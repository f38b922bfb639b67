// SPDX-License-Identifier: BSD-3-Clause
// The ticks of the last seconds without a recording: their range in virtual time, and their
// duration. On the servo thread each tick is either present or counted as lost.
#include "PlacedDevice.h"
#include "Haptics/Servo/ServoStep.h"

#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace
{
using namespace palpate::testing;

Body historyOf(vtkHapticSession* session)
{
  auto history = Body::New();
  session->GetRecorder()->GetHistory(history);
  return history;
}

/// Checks that the history equals the end of a recording of the same run, bit by bit.
void checkIsEndOf(vtkPolyData* recording, vtkPolyData* history)
{
  const vtkIdType count = history->GetNumberOfPoints();
  const vtkIdType first = recording->GetNumberOfPoints() - count;
  PALPATE_CHECK(first >= 0 && history->GetNumberOfLines() == (count > 0 ? 1 : 0));
  vtkPointData* expected = recording->GetPointData();
  PALPATE_CHECK(history->GetPointData()->GetNumberOfArrays() == expected->GetNumberOfArrays());
  for (int k = 0; k < expected->GetNumberOfArrays(); ++k)
  {
    vtkDataArray* whole = expected->GetArray(k);
    vtkDataArray* end = history->GetPointData()->GetArray(whole->GetName());
    PALPATE_CHECK(end && end->GetNumberOfTuples() == count);
    for (vtkIdType i = 0; end && i < count; ++i)
    {
      for (int c = 0; c < whole->GetNumberOfComponents(); ++c)
      {
        PALPATE_CHECK(end->GetComponent(i, c) == whole->GetComponent(first + i, c));
      }
    }
  }
}

void checkVirtualTime(vtkPolyData* body)
{
  for (const double rate : { 250.0, 1000.0, 8000.0 })
  {
    vtkNew<vtkHapticSession> all;
    vtkNew<vtkHapticSession> last;
    for (vtkHapticSession* session : { all.Get(), last.Get() })
    {
      session->SetBody(body);
      session->SetResponseName("Sphere");
      session->SetRate(rate);
      session->GetDevice()->SetPath(slidePath(body, { 0.0, 0.0, 1.0 }, { 0.05, 0.0, 1.0 }, 0.8));
    }
    last->GetRecorder()->RecordingOff();
    last->GetRecorder()->SetHistorySeconds(0.4);
    PALPATE_CHECK(historyOf(last)->GetNumberOfPoints() == 0);
    PALPATE_CHECK(all->Start() && last->Start());
    double time = 0.0;
    for (const double seconds : { 0.1, 0.3, 0.016, 0.9, 0.004 })
    {
      all->Step(seconds);
      last->Step(seconds);
      time += seconds;
      Body recording = Body::New();
      all->GetRecorder()->GetRecording(recording);
      const Body history = historyOf(last);
      PALPATE_CHECK(history->GetNumberOfPoints() == std::lround(std::min(time, 0.4) * rate));
      checkIsEndOf(recording, history);
      PALPATE_CHECK(last->GetRecorder()->GetTicks().empty() &&
        last->GetRecorder()->GetNumberOfLostTicks() == 0);
      PALPATE_CHECK(historyOf(all)->GetNumberOfPoints() == 0); // the default is no history
    }
    PALPATE_CHECK(last->GetNumberOfStarts() == 1 && last->Start());
    PALPATE_CHECK(last->GetNumberOfStarts() == 2);
    PALPATE_CHECK(historyOf(last)->GetNumberOfPoints() == 0);
    last->SetBody(nullptr);
    Messages messages(last);
    PALPATE_CHECK(!last->Start() && last->GetNumberOfStarts() == 2);
    PALPATE_CHECK_TEXT(messages.takeErrors(), "body");
  }
  vtkNew<vtkHapticSession> session;
  PALPATE_CHECK(session->GetRecorder()->GetHistorySeconds() == 0.0);
  session->GetRecorder()->SetHistorySeconds(-1.0);
  PALPATE_CHECK(session->GetRecorder()->GetHistorySeconds() == 0.0);
  session->GetRecorder()->SetHistorySeconds(1e9);
  PALPATE_CHECK(session->GetRecorder()->GetHistorySeconds() == 100.0);
}

template <class Condition>
void waitFor(const Condition& condition)
{
  for (int i = 0; i < 10000 && !condition(); ++i) // at most about 20 s, on a loaded machine
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  PALPATE_CHECK(condition());
}

double sumOf(vtkTable* table, const char* column)
{
  double sum = 0.0;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    sum += table->GetValueByName(row, column).ToDouble();
  }
  return sum;
}

/// The counts add up to the number of ticks, the classes are contiguous, and each quantile is in
/// its class.
void checkHistogram(vtkHapticSession* session)
{
  vtkNew<vtkTable> histogram;
  vtkNew<vtkTable> timing;
  session->GetRecorder()->GetTimingHistogram(histogram);
  session->GetRecorder()->GetTiming(timing);
  const auto ticks = static_cast<double>(session->GetNumberOfTicks());
  PALPATE_CHECK(sumOf(histogram, "Tick") == ticks && sumOf(histogram, "WakeUp") == ticks);
  PALPATE_CHECK(sumOf(histogram, "Period") == ticks - 1.0);
  double before = 0.0;
  for (vtkIdType row = 0; row < histogram->GetNumberOfRows(); ++row)
  {
    const double from = histogram->GetValueByName(row, "From (us)").ToDouble();
    const double upTo = histogram->GetValueByName(row, "To (us)").ToDouble();
    PALPATE_CHECK(row == 0 || from == before);
    PALPATE_CHECK(upTo > from && upTo - from <= std::max(0.00101, 1.001 * upTo / 32.0));
    before = upTo;
  }
  for (const char* name : { "Period", "WakeUp", "Tick" })
  {
    const double median =
      timing->GetValueByName(0, (std::string(name) + " (us)").c_str()).ToDouble();
    double upToMedian = 0.0;
    double below = 0.0;
    for (vtkIdType row = 0; row < histogram->GetNumberOfRows(); ++row)
    {
      const double count = histogram->GetValueByName(row, name).ToDouble();
      const double upTo = histogram->GetValueByName(row, "To (us)").ToDouble();
      upToMedian += upTo <= median + 1e-9 ? count : 0.0;
      below += upTo < median - 1e-9 ? count : 0.0;
    }
    PALPATE_CHECK(upToMedian >= 0.5 * sumOf(histogram, name));
    PALPATE_CHECK(below < 0.5 * sumOf(histogram, name) + 1.0);
  }
}

void checkRealTime(vtkPolyData* body)
{
  vtkNew<vtkHapticSession> session;
  session->SetBody(body);
  session->SetResponseName("Flat");
  session->RealTimeOn();
  session->GetRecorder()->RecordingOff();
  session->GetRecorder()->SetHistorySeconds(0.25);
  session->GetDevice()->Use(std::make_unique<PlacedDevice>(deviceOf(100.0, 1e6)));
  PALPATE_CHECK(session->Start());

  // If the ticks are not read, 250 ticks are kept. The others are lost and counted.
  waitFor([&] { return session->GetNumberOfTicks() > 600; });
  PALPATE_CHECK(session->GetRecorder()->GetNumberOfLostTicks() >= 300);
  Body history = historyOf(session);
  PALPATE_CHECK(history->GetNumberOfPoints() <= 250 && history->GetNumberOfPoints() > 0);

  // If the ticks are read at the rate of a display, no further tick is lost, and the history
  // advances.
  const vtkIdType lost = session->GetRecorder()->GetNumberOfLostTicks();
  const vtkIdType then = session->GetNumberOfTicks();
  waitFor(
    [&]
    {
      history = historyOf(session);
      return session->GetNumberOfTicks() > then + 700;
    });
  // A machine that stops for 0.25 s would lose some ticks, which are counted.
  PALPATE_CHECK(session->GetRecorder()->GetNumberOfLostTicks() - lost <=
    session->GetNumberOfTicks() - then - 250);
  vtkDataArray* time = history->GetPointData()->GetArray("Time");
  const vtkIdType count = time->GetNumberOfTuples();
  PALPATE_CHECK(count > 0 && count <= 250);
  PALPATE_CHECK(time->GetTuple1(count - 1) - time->GetTuple1(0) < 0.25);
  for (vtkIdType i = 1; i < count; ++i)
  {
    PALPATE_CHECK(time->GetTuple1(i) > time->GetTuple1(i - 1));
  }
  session->Stop();
  vtkNew<vtkTable> statistics;
  session->GetRecorder()->GetStatistics(statistics);
  PALPATE_CHECK(statistics->GetValueByName(0, "Overruns").ToDouble() ==
    static_cast<double>(session->GetRecorder()->GetNumberOfLostTicks()));
  PALPATE_CHECK(session->GetRecorder()->GetTicks().empty());
  checkHistogram(session);
}

void checkNoHistogram(vtkPolyData* body)
{
  vtkNew<vtkHapticSession> session;
  vtkNew<vtkTable> histogram;
  session->GetRecorder()->GetTimingHistogram(histogram);
  PALPATE_CHECK(histogram->GetNumberOfRows() == 0);
  session->SetBody(body);
  session->SetResponseName("Flat");
  session->GetDevice()->SetPath(slidePath(body, { 0.0, 0.0, 1.0 }, { 0.05, 0.0, 1.0 }, 0.8));
  PALPATE_CHECK(session->Start());
  session->Step(0.1);
  session->GetRecorder()->GetTimingHistogram(histogram);
  PALPATE_CHECK(histogram->GetNumberOfRows() == 0); // there are no times in virtual time
}
} // namespace

int TestHapticSessionHistory(int, char*[])
{
  const Body body = threeTools();
  checkVirtualTime(body);
  checkRealTime(body);
  checkNoHistogram(body);
  return palpate::testing::result();
}
