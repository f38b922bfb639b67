// SPDX-License-Identifier: BSD-3-Clause
// A path that tilts the tool: what the session tells of it and records, that a path without axes
// has none, and a hand that is turned while it is steered.
#include "Response/FilterChecks.h"
#include "SceneBodies.h"
#include "Haptics/Servo/ServoStep.h"

#include "vtkHapticSession.h"

#include <chrono>
#include <cmath>
#include <thread>

namespace
{
using namespace palpate::testing;

constexpr double Tilt = 0.3; // rad

/// The same way; the tool leans over towards x, from upright to Tilt in its second half.
Body tilting(vtkPolyData* path)
{
  Body turned = Body::New();
  turned->DeepCopy(path);
  const vtkIdType count = turned->GetNumberOfPoints();
  vtkNew<vtkDoubleArray> axes;
  axes->SetName("ToolAxis");
  axes->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double angle = i < count / 2 ? 0.0 : Tilt;
    axes->InsertNextTuple3(2.0 * std::sin(angle), 0.0, 2.0 * std::cos(angle)); // of any length
  }
  turned->GetPointData()->AddArray(axes);
  return turned;
}

vtkSmartPointer<vtkHapticSession> sessionOn(vtkPolyData* body, vtkPolyData* path)
{
  auto session = vtkSmartPointer<vtkHapticSession>::New();
  session->SetBody(body);
  session->GetDevice()->SetPath(path);
  // Its axes in the body: x along -y, y along x.
  session->GetDevice()->SetRight(0.0, -1.0, 0.0);
  session->GetDevice()->SetUp(1.0, 0.0, 0.0);
  return session;
}

void checkTold(vtkPolyData* body, vtkPolyData* path)
{
  const auto session = sessionOn(body, tilting(path));
  PALPATE_CHECK(session->Start());
  double axis[3];
  double torque[3];
  session->GetAxis(axis);
  PALPATE_CHECK(vtkMath::Norm(axis) == 0.0); // before the first tick
  session->Step(0.01);
  session->GetAxis(axis);
  PALPATE_CHECK_NEAR(axis[2], 1.0, 1e-12);
  session->Step(session->GetDevice()->GetPathDuration());
  session->GetAxis(axis);
  PALPATE_CHECK_NEAR(axis[0], std::sin(Tilt), 1e-12);
  PALPATE_CHECK_NEAR(axis[1], 0.0, 1e-12);
  PALPATE_CHECK_NEAR(axis[2], std::cos(Tilt), 1e-12);
  const auto& tick = session->GetNewestTick();
  session->GetIdealTorque(torque);
  PALPATE_CHECK(std::equal(torque, torque + 3, tick.idealTorque.data()));
  session->GetTorque(torque);
  PALPATE_CHECK(vtkMath::Norm(torque) == 0.0); // a stiff hand is sent none
  PALPATE_CHECK_NEAR(session->GetTilt(), vtkMath::DegreesFromRadians(tick.contact.tilt), 0.0);

  Body recording = Body::New();
  session->GetRecorder()->GetRecording(recording);
  vtkDataArray* axes = recording->GetPointData()->GetArray("ToolAxis");
  vtkDataArray* torques = recording->GetPointData()->GetArray("Torque");
  PALPATE_CHECK(axes && torques && axes->GetNumberOfTuples() == session->GetNumberOfTicks());
  if (axes)
  {
    double last[3];
    axes->GetTuple(axes->GetNumberOfTuples() - 1, last);
    PALPATE_CHECK(std::equal(last, last + 3, tick.axis.data()));
  }
}

void checkNotTold(vtkPolyData* body, vtkPolyData* path)
{
  const auto session = sessionOn(body, path);
  PALPATE_CHECK(session->Start());
  session->Step(0.5);
  double axis[3];
  session->GetAxis(axis);
  PALPATE_CHECK(vtkMath::Norm(axis) == 0.0 && session->GetTilt() == 0.0);
  Body recording = Body::New();
  session->GetRecorder()->GetRecording(recording);
  PALPATE_CHECK(!recording->GetPointData()->HasArray("ToolAxis"));
  PALPATE_CHECK(!recording->GetPointData()->HasArray("Torque"));
}

void checkSteered(vtkPolyData* body)
{
  const auto session = sessionOn(body, nullptr);
  session->SetRealTime(true);
  const double above[3] = { 0.0, 0.0, 1.0 };
  const double upright[3] = { 0.0, 0.0, 5.0 };
  const double leaning[3] = { std::sin(Tilt), 0.0, std::cos(Tilt) };
  session->GetDevice()->SteerTo(above);
  session->GetDevice()->TurnTo(upright);
  PALPATE_CHECK(session->Start());
  session->GetDevice()->TurnTo(leaning);
  double axis[3] = { 0.0, 0.0, 0.0 };
  // In 0.3 s e^-10 of the angle is left, 1e-5; waited for at most 20 s on a busy machine.
  for (int i = 0; i < 2000 && std::abs(axis[0] - leaning[0]) > 1e-4; ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    session->GetAxis(axis);
  }
  PALPATE_CHECK_NEAR(axis[0], leaning[0], 1e-4);
  PALPATE_CHECK_NEAR(axis[1], 0.0, 1e-12);
  session->Stop();
}

void checkErrors(vtkPolyData* body, vtkPolyData* path)
{
  Body wrong = tilting(path);
  vtkNew<vtkDoubleArray> flat;
  flat->SetName("ToolAxis");
  flat->SetNumberOfComponents(2);
  flat->SetNumberOfTuples(wrong->GetNumberOfPoints());
  flat->Fill(1.0);
  wrong->GetPointData()->AddArray(flat);
  const auto session = sessionOn(body, wrong);
  Messages messages(session);
  PALPATE_CHECK(!session->Start());
  PALPATE_CHECK_TEXT(
    messages.takeErrors(), "'ToolAxis' of the path must have 3 components, but has 2");
}
} // namespace

int TestHapticSessionTilt(int, char*[])
{
  const Body body = withResponse(planeBody(20.0, 20), "sphere:2");
  const Body path = slidePath(body, { 0.0, 0.0, 1.0 }, { 0.0, 0.0, 1.0 }, 1.0);
  checkTold(body, path);
  checkNotTold(body, path);
  checkSteered(body);
  checkErrors(body, path);
  return palpate::testing::result();
}
