// SPDX-License-Identifier: BSD-3-Clause
// Devices of a session: a rotated and scaled mapping, loss during contact and return, replay, and
// the servo thread, where every tick is recorded.
#include "PlacedDevice.h"
#include "Haptics/Servo/ServoStep.h"
#include "Haptics/Devices/TrajectoryFile.h"

#include "vtkTable.h"
#include "vtkVariant.h"

#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <thread>

namespace
{
using namespace palpate::testing;

/// With a scale of 2, the hand moves half as far for the same depth.
void checkMapping(vtkPolyData* body)
{
  vtkNew<vtkHapticSession> session;
  session->SetBody(body);
  session->SetResponseName("Flat");
  session->GetDevice()->SetScale(2.0);
  session->GetDevice()->SetOrigin(0.0, 0.0, 1.0);
  // A mapping of the device's z to the body's -x would need another normal. This mapping is a turn
  // about z.
  session->GetDevice()->SetRight(0.0, 3.0, 0.0);
  session->GetDevice()->SetUp(-1.0, 0.0, 0.0);
  PlacedDevice* device = pressed(session, deviceOf(100.0, 1e6));
  double tip[3];
  session->GetTip(tip);
  PALPATE_CHECK_NEAR(tip[0], -0.4, 1e-12); // y of the device, 0.2 mm, times two
  PALPATE_CHECK_NEAR(tip[1], 0.6, 1e-12);
  PALPATE_CHECK_NEAR(tip[2], -1.0, 1e-12); // 1 mm, minus twice 1 mm
  PALPATE_CHECK_NEAR(device->Force, 11.04, 0.01);
}

/// A device is lost during contact and found again. Checks the state, zero force, and the device's
/// own message.
void checkLost(vtkPolyData* body)
{
  vtkNew<vtkHapticSession> session;
  session->SetBody(body);
  session->SetResponseName("Flat");
  PlacedDevice* device = pressed(session, deviceOf(100.0, 1e6));
  PALPATE_CHECK(session->GetState() == vtkHapticSession::Running);
  PALPATE_CHECK(
    session->GetDevice()->GetStatus() == "in place" && session->GetSafetyText().empty());
  device->Lost = true;
  session->Step(0.001); // one tick
  PALPATE_CHECK(session->GetState() == vtkHapticSession::DeviceLost);
  PALPATE_CHECK(device->Force == 0.0 && appliedTo(session) == 0.0);
  PALPATE_CHECK(session->GetDevice()->GetStatus() == "pulled out");
  PALPATE_CHECK_TEXT(session->GetSafetyText(), "no force", "position");
  device->Lost = false;
  session->Step(0.001);
  PALPATE_CHECK(session->GetState() == vtkHapticSession::Running);
  PALPATE_CHECK(device->Force == 0.0); // it returned inside the body, so the gate is closed
  session->Stop();
  PALPATE_CHECK(device->Force == 0.0);
}

/// Returns a session in virtual time whose tool has slid over the body.
vtkSmartPointer<vtkHapticSession> sessionAfterSlide(vtkPolyData* body)
{
  auto session = vtkSmartPointer<vtkHapticSession>::New();
  session->SetBody(body);
  session->SetResponseName("Sphere");
  session->SetBodyName("the ball");
  session->SetMaterial("E = 1 MPa, nu = 0.5");
  session->GetDevice()->SetPath(slidePath(body, { 0.0, 0.0, 1.0 }, { 0.05, 0.0, 1.0 }, 0.8));
  PALPATE_CHECK(session->Start());
  session->Step(session->GetDevice()->GetPathDuration());
  return session;
}

/// A recording that is written and replayed in virtual time gives the same bits.
void checkReplay(vtkPolyData* body)
{
  const auto first = sessionAfterSlide(body);
  const std::string file = "TestHapticSessionDevices-replay.csv";
  PALPATE_CHECK(palpate::writeTrajectory(
    file, first->GetRecorder()->GetTicks(), first->GetRecorder()->GetSetups())
                  .empty());
  PALPATE_CHECK(first->GetReplayText().empty());
  vtkNew<vtkHapticSession> again;
  Messages messages(again);
  again->SetBody(body);
  again->SetResponseName("Sphere");
  PALPATE_CHECK(again->GetDevice()->Open("replay:" + file));
  std::remove(file.c_str()); // the file has been read already
  PALPATE_CHECK(again->Start() && messages.none());
  again->Step(first->GetDevice()->GetPathDuration());
  const std::vector<palpate::Tick>& ticks = again->GetRecorder()->GetTicks();
  const std::vector<palpate::Tick>& recorded = first->GetRecorder()->GetTicks();
  PALPATE_CHECK(ticks.size() == recorded.size());
  for (std::size_t i = 0; i < std::min(ticks.size(), recorded.size()); ++i)
  {
    PALPATE_CHECK(ticks[i].tip == recorded[i].tip);
    PALPATE_CHECK(ticks[i].appliedForce == recorded[i].appliedForce);
  }
  // The material is what the program named, the tool that of the response.
  PALPATE_CHECK_TEXT(
    again->GetReplayText(), "Replay: recorded with body the ball, tool sphere:6.35");
  again->SetResponseName("Flat");
  again->SetMaterial("E = 2 MPa, nu = 0.5");
  PALPATE_CHECK_TEXT(again->GetReplayText(),
    "Replay: recorded with another setup: tool sphere:6.35 (here flat:1.6), material E = 1 MPa, nu "
    "= 0.5 (here E = 2 MPa, nu = 0.5)");
  again->SetResponseName("Sphere");
  Messages refusals(again->GetDevice());
  PALPATE_CHECK(!again->GetDevice()->Open("replay:" + file));
  PALPATE_CHECK_TEXT(refusals.takeErrors(), file.c_str());
  PALPATE_CHECK(again->Start()); // the previous device is still in use
}

/// A recording that begins in the middle of a session is replayed immediately from its first row.
void checkReplayFromTheMiddle(vtkPolyData* body)
{
  const auto first = sessionAfterSlide(body);
  std::vector<palpate::Tick> ticks = first->GetRecorder()->GetTicks();
  const auto half = static_cast<std::ptrdiff_t>(ticks.size() / 2);
  ticks.erase(ticks.begin(), ticks.begin() + half);
  const std::string file = "TestHapticSessionDevices-middle.csv";
  PALPATE_CHECK(palpate::writeTrajectory(file, ticks).empty());
  vtkNew<vtkHapticSession> again;
  again->SetBody(body);
  again->SetResponseName("Sphere");
  PALPATE_CHECK(again->GetDevice()->Open("replay:" + file));
  std::remove(file.c_str());
  PALPATE_CHECK(again->Start());
  const double duration = ticks.back().time - ticks.front().time;
  PALPATE_CHECK(std::abs(again->GetDevice()->GetPathDuration() - duration) < 1e-9);
  again->Step(duration);
  const std::vector<palpate::Tick>& played = again->GetRecorder()->GetTicks();
  PALPATE_CHECK(played.size() + 1 >= ticks.size() && played.size() <= ticks.size() + 1);
  for (std::size_t i = 0; i < std::min(played.size(), ticks.size()); ++i)
  {
    // The replay uses differences of times, so a tip between two rows has a rounding error.
    PALPATE_CHECK((played[i].tip - ticks[i].tip).norm() < 1e-9);
  }
}

/// On the servo thread every tick is recorded. The number of ticks is checked independently.
void checkRealTime(vtkPolyData* body)
{
  vtkNew<vtkHapticSession> session;
  session->SetBody(body);
  session->SetResponseName("Flat");
  session->RealTimeOn();
  auto owned = std::make_unique<PlacedDevice>(deviceOf(100.0, 1e6));
  PlacedDevice* device = owned.get();
  session->GetDevice()->Use(std::move(owned));
  session->GetSafety()->PassivityControlOff();
  PALPATE_CHECK(session->GetRecorder()->GetRealTimeGrant().empty());
  PALPATE_CHECK(session->Start());
  PALPATE_CHECK(!session->GetRecorder()->GetRealTimeGrant().empty());
  const auto waitFor = [&session](auto condition)
  {
    for (int i = 0; i < 10000 && !condition(); ++i) // at most about 20 s, on a loaded machine
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      session->GetState(); // collects the recorded ticks, as a display would
    }
    return condition();
  };
  PALPATE_CHECK(waitFor([&] { return session->GetNumberOfTicks() > 50; }));
  device->Height = -1e-3;
  PALPATE_CHECK(waitFor([&] { return device->Force > 11.0; }));
  session->SetResponseName("Small");
  PALPATE_CHECK(session->ApplyChanges());
  PALPATE_CHECK(waitFor([&] { return device->Force < 6.0; }));
  device->Lost = true;
  PALPATE_CHECK(waitFor([&] { return session->GetState() == vtkHapticSession::DeviceLost; }));
  PALPATE_CHECK(device->Force == 0.0);
  device->Lost = false;
  PALPATE_CHECK(waitFor([&] { return session->GetState() == vtkHapticSession::Running; }));
  session->Stop();
  PALPATE_CHECK(device->Force == 0.0);
  PALPATE_CHECK(session->GetState() == vtkHapticSession::Stopped);

  vtkNew<vtkPolyData> recording;
  vtkNew<vtkTable> statistics;
  session->GetRecorder()->GetRecording(recording);
  session->GetRecorder()->GetStatistics(statistics);
  const auto value = [&statistics](const char* column)
  { return statistics->GetValueByName(0, column).ToDouble(); };
  PALPATE_CHECK(value("Overruns") == 0.0);
  PALPATE_CHECK(recording->GetNumberOfPoints() == session->GetNumberOfTicks());
  PALPATE_CHECK(value("Ticks") == static_cast<double>(session->GetNumberOfTicks()));
  PALPATE_CHECK(
    value("Missed") == static_cast<double>(session->GetRecorder()->GetNumberOfMissedTicks()));
  PALPATE_CHECK(value("InvalidSamples") > 0.0 && value("SceneChanges") == 1.0);
  PALPATE_CHECK(value("TicksInContact") > 0.0 && value("MedianTick (ns)") > 0.0);
  PALPATE_CHECK_NEAR(value("PeakForce (N)"), 11.04, 0.01);
  // Ticks that were not missed are at whole periods, in order. Both counts of missed ticks agree.
  vtkDataArray* time = recording->GetPointData()->GetArray("Time");
  double skipped = 0.0;
  for (vtkIdType i = 1; i < time->GetNumberOfTuples(); ++i)
  {
    const double periods = 1000.0 * (time->GetTuple1(i) - time->GetTuple1(i - 1));
    PALPATE_CHECK(periods > 0.5);
    PALPATE_CHECK_NEAR(periods, std::round(periods), 1e-6); // times of minutes in double precision
    skipped += std::round(periods) - 1.0;
  }
  PALPATE_CHECK(skipped <= value("Missed"));
  vtkNew<vtkTable> timing;
  session->GetRecorder()->GetTiming(timing);
  PALPATE_CHECK(timing->GetNumberOfRows() > 3 && timing->GetNumberOfColumns() == 4);
  for (vtkIdType column = 1; column < timing->GetNumberOfColumns(); ++column)
  {
    for (vtkIdType row = 1; row < timing->GetNumberOfRows(); ++row)
    {
      PALPATE_CHECK(
        timing->GetValue(row, column).ToDouble() >= timing->GetValue(row - 1, column).ToDouble());
    }
  }
  PALPATE_CHECK_TEXT(session->GetRecorder()->GetStatisticsText(), "missed", "wake-up", "worst");
}
} // namespace

int TestHapticSessionDevices(int, char*[])
{
  const Body body = threeTools();
  checkMapping(body);
  checkLost(body);
  checkReplayFromTheMiddle(body);
  checkReplay(body);
  checkRealTime(body);
  return palpate::testing::result();
}
