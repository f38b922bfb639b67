// SPDX-License-Identifier: BSD-3-Clause
// A session with two devices: the effect of one tool on the other, the sent and recorded forces of
// each device, the loss of one device, a change of the body under both, the servo thread, and
// refused combinations.
#include "PlacedDevice.h"
#include "Haptics/Servo/ServoStep.h"

#include "vtkTable.h"
#include "Mechanics/Numerics/Constants.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <initializer_list>
#include <string>
#include <thread>
#include <utility>

namespace
{
using namespace palpate::testing;
using palpate::Pi;
using Session = vtkSmartPointer<vtkHapticSession>;

constexpr double Modulus = 0.5 / (1.0 - 0.45 * 0.45); // E*, MPa
constexpr double Spring = 2.0 * 2.0 * Modulus;        // spring constant of the flat end, N/mm
constexpr double Apart = 6.0;                         // mm
constexpr double Mutual = 1.0 / (Pi * Modulus * Apart);

Body flatOn(bool isCoupled)
{
  auto filter = filterOf(planeBody(20.0, 20), "flat:2", 1.0);
  filter->SetYoungsModulus(0.5);
  filter->SetPoissonRatio(0.45);
  filter->SetCoupling(isCoupled);
  filter->Update();
  return filter->GetOutput();
}

/// A path at one place with given times and heights.
Body pathAt(double x, std::initializer_list<std::pair<double, double>> way)
{
  Body path = Body::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> times;
  times->SetName("Time");
  for (const auto& [time, height] : way)
  {
    points->InsertNextPoint(x, 0.3, height);
    times->InsertNextValue(time);
  }
  path->SetPoints(points);
  path->GetPointData()->AddArray(times);
  return path;
}

/// The first hand presses 0.5 mm deep within 0.1 s, the second 0.8 mm deep between 0.2 and 0.3 s.
Session twoOn(vtkPolyData* body)
{
  auto session = Session::New();
  session->SetBody(body);
  session->GetDevice()->SetPath(pathAt(0.0, { { 0.0, 1.0 }, { 0.1, -0.5 }, { 1.0, -0.5 } }));
  PALPATE_CHECK(session->AddDevice("simulated") == 1);
  PALPATE_CHECK(session->GetNumberOfDevices() == 2);
  session->GetDevice(1)->SetPath(
    pathAt(Apart, { { 0.0, 1.0 }, { 0.2, 1.0 }, { 0.3, -0.8 }, { 1.0, -0.8 } }));
  return session;
}

double forceOf(vtkHapticSession* session, int device)
{
  double force[3];
  session->GetForce(device, force);
  return force[2];
}

/// Force of the first of two springs, each of which lowers the surface under the other.
double coupled(double own, double other)
{
  return Spring * (own - Mutual * Spring * other) / (1.0 - std::pow(Mutual * Spring, 2));
}

void checkLift(vtkPolyData* body, bool isCoupled)
{
  constexpr double digits = 1e-5; // N; curves are stored as floats
  const Session session = twoOn(body);
  PALPATE_CHECK(session->Start());
  session->Step(0.15);
  PALPATE_CHECK_NEAR(forceOf(session, 0), 0.5 * Spring, digits);
  PALPATE_CHECK(forceOf(session, 1) == 0.0);
  session->Step(0.25);
  const double first = forceOf(session, 0);
  const double second = forceOf(session, 1);
  PALPATE_CHECK_NEAR(first, isCoupled ? coupled(0.5, 0.8) : 0.5 * Spring, digits);
  PALPATE_CHECK_NEAR(second, isCoupled ? coupled(0.8, 0.5) : 0.8 * Spring, digits);
  const double lifted = isCoupled ? Mutual * second * Spring : 0.0;
  PALPATE_CHECK_NEAR(0.5 * Spring - first, lifted, digits);
  PALPATE_CHECK(!isCoupled || lifted > 0.2);

  double tip[3];
  double same[3];
  session->GetTip(1, tip);
  PALPATE_CHECK_NEAR(tip[0], Apart, 1e-12);
  PALPATE_CHECK_NEAR(tip[2], -0.8, 1e-12);
  session->GetTip(same);
  session->GetTip(0, tip);
  PALPATE_CHECK(std::equal(tip, tip + 3, same) && tip[0] == 0.0);
  session->GetContactPoint(1, tip);
  PALPATE_CHECK_NEAR(tip[0], Apart, 1e-6);
  PALPATE_CHECK(session->GetContactCell(0) != session->GetContactCell(1));
  PALPATE_CHECK_NEAR(session->GetDeflection(1), second / Spring, digits);
  PALPATE_CHECK(session->GetContactState(1) == static_cast<int>(palpate::ContactState::Slide));
  PALPATE_CHECK(session->GetSafetyText(1).empty());
  PALPATE_CHECK(session->GetState(1) == vtkHapticSession::Running);
  for (const int none : { -1, 2 })
  {
    session->GetTip(none, tip);
    PALPATE_CHECK(vtkMath::Norm(tip) == 0.0 && !session->GetDevice(none));
    PALPATE_CHECK(session->GetContactCell(none) == -1);
  }
}

void checkRecorded(vtkPolyData* body)
{
  const Session session = twoOn(body);
  PALPATE_CHECK(session->Start());
  session->Step(0.4);
  Body first = Body::New();
  Body second = Body::New();
  Body none = Body::New();
  session->GetRecorder()->GetRecording(first);
  session->GetRecorder()->GetRecording(second, 1);
  session->GetRecorder()->GetRecording(none, 2);
  PALPATE_CHECK(first->GetNumberOfPoints() == 400 && second->GetNumberOfPoints() == 400);
  PALPATE_CHECK(none->GetNumberOfPoints() == 0);
  PALPATE_CHECK_NEAR(first->GetPoint(399)[2], -0.5, 1e-12);
  PALPATE_CHECK_NEAR(second->GetPoint(399)[2], -0.8, 1e-12);
  vtkNew<vtkTable> peaks;
  session->GetRecorder()->GetStatistics(peaks, 1);
  // The peak occurs during motion: with two iterations per tick, the error is below 1e-3 of the
  // force.
  PALPATE_CHECK_NEAR(
    peaks->GetValueByName(0, "PeakAppliedForce (N)").ToDouble(), forceOf(session, 1), 1e-3);

  // After the second device has been removed, the session gives the same bits as a session that
  // never had a second device.
  session->RemoveAddedDevices();
  PALPATE_CHECK(session->Start());
  session->Step(0.4);
  const auto alone = Session::New();
  alone->SetBody(body);
  alone->GetDevice()->SetPath(pathAt(0.0, { { 0.0, 1.0 }, { 0.1, -0.5 }, { 1.0, -0.5 } }));
  PALPATE_CHECK(alone->Start());
  alone->Step(0.4);
  const auto& ticks = session->GetRecorder()->GetTicks();
  const auto& same = alone->GetRecorder()->GetTicks();
  PALPATE_CHECK(ticks.size() == same.size());
  for (std::size_t i = 0; i < std::min(ticks.size(), same.size()); ++i)
  {
    PALPATE_CHECK(ticks[i].deviceForce == same[i].deviceForce && ticks[i].tip == same[i].tip);
  }
}

void checkChange(vtkPolyData* body)
{
  const Session session = twoOn(body);
  PALPATE_CHECK(session->Start());
  session->Step(0.4);
  session->SetBody(flatOn(false));
  PALPATE_CHECK(session->ApplyChanges());
  session->Step(0.026); // in the middle of the ramp of 50 ms, which begins with the second tick
  PALPATE_CHECK_NEAR(forceOf(session, 0), 0.5 * (coupled(0.5, 0.8) + 0.5 * Spring), 1e-5);
  PALPATE_CHECK_NEAR(forceOf(session, 1), 0.5 * (coupled(0.8, 0.5) + 0.8 * Spring), 1e-5);
  session->Step(0.03);
  PALPATE_CHECK_NEAR(forceOf(session, 0), 0.5 * Spring, 1e-5); // rounding of floats
  PALPATE_CHECK_NEAR(forceOf(session, 1), 0.8 * Spring, 1e-5);
}

PlacedDevice* place(vtkHapticDevice* at)
{
  auto owned = std::make_unique<PlacedDevice>(deviceOf(10.0, 1e6));
  PlacedDevice* device = owned.get();
  at->Use(std::move(owned));
  return device;
}

/// Waits until the written force has this value, for at most 20 s on a loaded machine.
bool comesTo(const PlacedDevice* device, double force)
{
  for (int i = 0; i < 2000 && !(std::abs(device->Force - force) < 1e-4); ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  // Tolerance for floats and the error after two iterations.
  return std::abs(device->Force - force) < 1e-4;
}

void checkRealTime(vtkPolyData* body)
{
  const auto session = Session::New();
  session->SetBody(body);
  session->SetRealTime(true);
  session->GetSafety()->PassivityControlOff(); // the positions are prescribed, so no loop is closed
  PALPATE_CHECK(session->AddDevice("simulated") == 1);
  PlacedDevice* first = place(session->GetDevice());
  PlacedDevice* second = place(session->GetDevice(1));
  session->GetDevice(1)->SetOrigin(Apart, 0.0, 0.0);
  PALPATE_CHECK(session->Start());
  while (session->GetNumberOfTicks() < 10)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  first->Height = -5e-4;
  PALPATE_CHECK(comesTo(first, 0.5 * Spring));
  second->Height = -8e-4;
  PALPATE_CHECK(comesTo(first, coupled(0.5, 0.8)));
  PALPATE_CHECK(comesTo(second, coupled(0.8, 0.5)));
  second->Lost = true;
  PALPATE_CHECK(comesTo(first, 0.5 * Spring) && second->Force == 0.0);
  PALPATE_CHECK(session->GetState(1) == vtkHapticSession::DeviceLost);
  PALPATE_CHECK(session->GetState() == vtkHapticSession::Running);
  PALPATE_CHECK(forceOf(session, 1) == 0.0);
  PALPATE_CHECK_NEAR(forceOf(session, 0), 0.5 * Spring, 1e-4);
  session->Stop();
  PALPATE_CHECK(first->Force == 0.0 && second->Force == 0.0);
  const auto missing =
    session->GetNumberOfTicks() - session->GetRecorder()->GetNumberOfLostTicks() / 2;
  PALPATE_CHECK(static_cast<vtkIdType>(session->GetRecorder()->GetTicks(1).size()) >= missing - 1);
}

void checkErrors(vtkPolyData* body)
{
  const auto session = Session::New();
  session->SetBody(body);
  Messages messages(session);
  PALPATE_CHECK(session->AddDevice("simulated") == 1);
  PALPATE_CHECK(session->AddDevice("simulated") == 2);
  PALPATE_CHECK(session->AddDevice("plant") == 3);
  PALPATE_CHECK(session->AddDevice("plant") == -1);
  PALPATE_CHECK_TEXT(messages.takeErrors(), "a session has at most 4 devices");
  session->RemoveAddedDevices();
  PALPATE_CHECK(session->GetNumberOfDevices() == 1);
  const Body path = pathAt(0.0, { { 0.0, 1.0 }, { 0.1, -0.5 } });
  session->GetDevice()->SetPath(path);
  session->AddDevice("simulated");
  PALPATE_CHECK(!session->Start()); // the second device has no path
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Device 1: The simulated device needs a path");
  session->GetDevice(1)->SetPath(path);
  const auto modified = session->GetMTime();
  session->GetDevice(1)->SetScale(2.0);
  PALPATE_CHECK(session->GetMTime() > modified);
  session->SetDevice(session->GetDevice(1));
  PALPATE_CHECK(!session->Start());
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Device 1: It is the same object as another device");
}
} // namespace

int TestHapticSessionHands(int, char*[])
{
  const Body body = flatOn(true);
  checkLift(body, true);
  checkLift(flatOn(false), false);
  checkRecorded(body);
  checkChange(body);
  checkRealTime(body);
  checkErrors(body);
  return palpate::testing::result();
}
