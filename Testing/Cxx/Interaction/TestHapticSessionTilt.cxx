// SPDX-License-Identifier: BSD-3-Clause
// A path that tilts the tool: the values of the session and its recording. A path without axes
// gives no axes. A hand that is turned while it is steered.
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

/// Returns the same path with axes. In the second half the tool is tilted towards x by Tilt; in the
/// first half it is upright.
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
  // The device's axes in the body: x along -y, y along x.
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
  PALPATE_CHECK(vtkMath::Norm(axis) == 0.0); // no axis before the first tick
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
  PALPATE_CHECK(vtkMath::Norm(torque) == 0.0); // a stiff hand receives no torque
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
  // After 0.3 s, e^-10 of the angle is left, about 1e-5 rad. Waits for at most 20 s on a loaded
  // machine.
  for (int i = 0; i < 2000 && std::abs(axis[0] - leaning[0]) > 1e-4; ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    session->GetAxis(axis);
  }
  PALPATE_CHECK_NEAR(axis[0], leaning[0], 1e-4);
  PALPATE_CHECK_NEAR(axis[1], 0.0, 1e-12);
  session->Stop();
}

/// A flat end whose deepest point is a fifth of its radius deep: upright, and tilted by 5 degrees.
void checkFelt()
{
  constexpr double radius = 3.0;
  const double angle = vtkMath::RadiansFromDegrees(5.0);
  vtkNew<vtkToolContactResponse> filter;
  filter->SetInputData(planeBody(20.0, 8));
  filter->SetTool(makeTool("flat:3"));
  filter->SetYoungsModulus(1.0);
  filter->SetPoissonRatio(0.0);
  filter->SetMaximumDeflection(1.0);
  filter->SetMaximumTilt(10.0);
  makePlain(filter);
  filter->Update();
  const auto pressed = [&filter](double tilt)
  {
    const double depth = 0.2 * radius - radius * std::sin(tilt);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->InsertNextPoint(0.3, 0.7, 2.0);
    points->InsertNextPoint(0.3, 0.7, -depth);
    points->InsertNextPoint(0.3, 0.7, -depth);
    vtkNew<vtkCellArray> line;
    line->InsertNextCell({ 0, 1, 2 });
    vtkNew<vtkDoubleArray> time;
    time->SetName("Time");
    vtkNew<vtkDoubleArray> axes;
    axes->SetName("ToolAxis");
    axes->SetNumberOfComponents(3);
    for (const double at : { 0.0, 0.5, 0.6 })
    {
      time->InsertNextValue(at);
      axes->InsertNextTuple3(std::sin(tilt), 0.0, std::cos(tilt));
    }
    Body path = Body::New();
    path->SetPoints(points);
    path->SetLines(line);
    path->GetPointData()->AddArray(time);
    path->GetPointData()->AddArray(axes);
    auto session = vtkSmartPointer<vtkHapticSession>::New();
    session->SetBody(filter->GetOutput());
    session->GetDevice()->SetPath(path);
    PALPATE_CHECK(session->Start());
    session->Step(0.6);
    return session;
  };
  double force[3];
  double torque[3];
  const auto upright = pressed(0.0);
  upright->GetIdealForce(force);
  PALPATE_CHECK_NEAR(force[2], 2.0 * radius * 0.2 * radius, 1e-5);
  upright->GetIdealTorque(torque);
  // Tolerance of the table near upright.
  PALPATE_CHECK(vtkMath::Norm(torque) < 1e-3 * radius * force[2]);
  const double whole = force[2];
  const auto leaning = pressed(angle);
  leaning->GetIdealForce(force);
  leaning->GetIdealTorque(torque);
  // tilt_bem.csv, D = 0.2 of the radius: T = 0.5757. The torque is 0.1073 E* a^3, about -y.
  PALPATE_CHECK_NEAR(force[2] / whole, 0.5757, 0.003);
  PALPATE_CHECK_NEAR(torque[1], -0.1073 * radius * radius * radius, 0.02);
  PALPATE_CHECK_NEAR(leaning->GetTilt(), 5.0, 1e-9);
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
  checkFelt();
  checkErrors(body, path);
  return palpate::testing::result();
}
