// SPDX-License-Identifier: BSD-3-Clause
// The settings of forces, surface and friction in a session. Invalid values are refused by name.
// Valid values take effect in virtual time and in real time.
#include "Contact/ContactSettings.h"
#include "Response/FilterChecks.h"
#include "SceneBodies.h"
#include "Haptics/Servo/ServoStep.h"

#include "vtkHapticSession.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <chrono>
#include <cmath>
#include <functional>
#include <thread>

namespace
{
using namespace palpate::testing;

constexpr double Friction = 0.5;

/// Presses 0.5 mm into the plane z = 0 and slides 4 mm along x, in 1 s.
Body draggedPath()
{
  const double way[4][4] = { { 0.0, 0.3, 0.2, 1.0 }, { 0.2, 0.3, 0.2, -0.5 },
    { 0.9, 4.3, 0.2, -0.5 }, { 1.0, 4.3, 0.2, -0.5 } };
  auto path = Body::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> time;
  time->SetName("Time");
  for (const auto& point : way)
  {
    time->InsertNextValue(point[0]);
    points->InsertNextPoint(point + 1);
  }
  path->SetPoints(points);
  path->GetPointData()->AddArray(time);
  return path;
}

void checkDefaults()
{
  vtkNew<vtkHapticSession> session;
  const palpate::ContactSettings kernel;
  vtkContactSettings* settings = session->GetSettings();
  PALPATE_CHECK(settings->GetForceForm() == static_cast<int>(kernel.form));
  PALPATE_CHECK(settings->GetContactSurface() == static_cast<int>(kernel.surface));
  PALPATE_CHECK(settings->GetFrictionModel() == static_cast<int>(kernel.friction.model));
  PALPATE_CHECK(settings->GetFrictionCoefficient() == kernel.friction.coefficient);
  PALPATE_CHECK(settings->GetTangentialStiffness() == kernel.friction.tangentialStiffness);
  PALPATE_CHECK(settings->GetFrictionBreakaway() == kernel.friction.breakaway);
  PALPATE_CHECK(settings->GetFrictionStickRadius() == kernel.friction.stickRadius);
  PALPATE_CHECK(settings->GetPoissonRatio() == kernel.friction.poissonRatio);
}

void checkRefused(vtkPolyData* body)
{
  using Settings = vtkContactSettings*;
  struct Wrong
  {
    const char* name;
    const char* value;
    std::function<void(Settings)> set;
  };
  const std::vector<Wrong> wrong = {
    { "Force Form", "7", [](Settings s) { s->SetForceForm(7); } },
    { "Contact Surface", "-1", [](Settings s) { s->SetContactSurface(-1); } },
    { "Friction Model", "3", [](Settings s) { s->SetFrictionModel(3); } },
    { "Friction Coefficient", "nan", [](Settings s) { s->SetFrictionCoefficient(std::nan("")); } },
    { "Tangential Stiffness", "-2", [](Settings s) { s->SetTangentialStiffness(-2.0); } },
    { "Friction Breakaway", "2", [](Settings s) { s->SetFrictionBreakaway(2.0); } },
    { "Friction Stick Radius", "0.25", [](Settings s) { s->SetFrictionStickRadius(0.25); } },
    { "Poisson's Ratio", "0.75", [](Settings s) { s->SetPoissonRatio(0.75); } },
  };
  for (const Wrong& setting : wrong)
  {
    for (const bool realTime : { false, true })
    {
      vtkNew<vtkHapticSession> session;
      Messages messages(session);
      session->SetBody(body);
      session->GetDevice()->SetPath(draggedPath());
      session->SetRealTime(realTime);
      setting.set(session->GetSettings());
      PALPATE_CHECK(!session->Start());
      PALPATE_CHECK_TEXT(messages.takeErrors(), setting.name, "must", setting.value);
      PALPATE_CHECK(session->GetState() == vtkHapticSession::Stopped);
    }
  }
}

/// Friction in getters, recording and statistics. A flat punch of 1 mm at a depth of 0.5 mm has
/// 3.45 N.
void checkFrictionIsTold(vtkPolyData* body)
{
  vtkNew<vtkHapticSession> session;
  session->SetBody(body);
  session->GetDevice()->SetPath(draggedPath());
  session->GetSettings()->SetFrictionCoefficient(Friction);
  session->GetSettings()->SetTangentialStiffness(4.0);
  double friction[3] = { 1.0, 1.0, 1.0 };
  session->GetFrictionForce(friction);
  PALPATE_CHECK(vtkMath::Norm(friction) == 0.0);
  PALPATE_CHECK(session->Start());
  // has no effect, because settings are read at Start
  session->GetSettings()->SetFrictionCoefficient(0.0);
  session->Step(1.0);
  session->GetFrictionForce(friction);
  double total[3];
  session->GetIdealForce(total);
  const double normal = 2.0 * 3.45 * 0.5;
  PALPATE_CHECK_NEAR(friction[0], -Friction * normal, 1e-6); // stored as floats
  PALPATE_CHECK_NEAR(friction[1], 0.0, 1e-12);
  PALPATE_CHECK_NEAR(friction[2], 0.0, 1e-12);
  PALPATE_CHECK_NEAR(total[0], friction[0], 1e-12);
  PALPATE_CHECK_NEAR(total[2], normal, 1e-6);

  vtkNew<vtkPolyData> recording;
  session->GetRecorder()->GetRecording(recording);
  vtkPointData* data = recording->GetPointData();
  double peak = 0.0;
  int sticking = 0;
  int sliding = 0;
  for (vtkIdType i = 0; i < recording->GetNumberOfPoints(); ++i)
  {
    const auto& contact = session->GetRecorder()->GetTicks()[static_cast<std::size_t>(i)].contact;
    double f[3];
    double force[3];
    double n[3];
    data->GetArray("FrictionForce")->GetTuple(i, f);
    data->GetArray("Force")->GetTuple(i, force);
    data->GetArray("Normal")->GetTuple(i, n);
    const double pressing = data->GetArray("NormalForce")->GetTuple1(i);
    PALPATE_CHECK(std::equal(f, f + 3, contact.friction.data()));
    for (int k = 0; k < 3; ++k)
    {
      PALPATE_CHECK_NEAR(force[k], pressing * n[k] + f[k], 1e-14); // rounding error of 4 N
    }
    PALPATE_CHECK_NEAR(vtkMath::Dot(f, n), 0.0, 1e-14);
    peak = std::max(peak, vtkMath::Norm(f));
    sticking += data->GetArray("ContactState")->GetTuple1(i) == 1.0;
    sliding += data->GetArray("ContactState")->GetTuple1(i) == 2.0;
  }
  PALPATE_CHECK(sticking > 50 && sliding > 400);
  vtkNew<vtkTable> statistics;
  session->GetRecorder()->GetStatistics(statistics);
  PALPATE_CHECK(statistics->GetValueByName(0, "PeakFriction (N)").ToDouble() == peak);
}

/// A new coefficient applies to the sliding contact from the tick of the change. During the change
/// of 50 ms the force is between Coulomb's limits of both coefficients.
void checkFrictionChange(vtkPolyData* body)
{
  constexpr double normal = 2.0 * 3.45 * 0.5;
  constexpr double rounding = 1e-6; // rounding error of curves that are stored as floats
  vtkNew<vtkHapticSession> session;
  session->SetBody(body);
  session->GetDevice()->SetPath(draggedPath());
  session->GetSettings()->SetFrictionCoefficient(Friction);
  session->GetSettings()->SetTangentialStiffness(4.0);
  PALPATE_CHECK(session->Start());
  session->Step(0.8);
  double friction[3];
  session->GetFrictionForce(friction);
  PALPATE_CHECK_NEAR(vtkMath::Norm(friction), Friction * normal, rounding);
  const double less = 0.1 * Friction;
  session->GetSettings()->SetFrictionCoefficient(less);
  PALPATE_CHECK(session->ApplyChanges());
  for (int tick = 0; tick < 60; ++tick)
  {
    session->Step(0.001);
    session->GetFrictionForce(friction);
    PALPATE_CHECK(vtkMath::Norm(friction) < less * normal + rounding);
    double force[3];
    session->GetIdealForce(force);
    const double along = std::hypot(force[0], force[1]);
    PALPATE_CHECK(along < Friction * normal + rounding);
    PALPATE_CHECK(tick < 51 || along < less * normal + rounding);
  }
  session->Step(0.02); // the hand is still moving
  session->GetFrictionForce(friction);
  PALPATE_CHECK_NEAR(vtkMath::Norm(friction), less * normal, rounding);
}

/// On the servo thread the contact slides with the same friction.
void checkRealTime(vtkPolyData* body)
{
  vtkNew<vtkHapticSession> session;
  session->SetBody(body);
  session->RealTimeOn();
  session->GetSettings()->SetFrictionCoefficient(Friction);
  session->GetSettings()->SetTangentialStiffness(4.0);
  const double start[3] = { 0.3, 0.2, 1.0 };
  session->GetDevice()->SteerTo(start);
  PALPATE_CHECK(session->Start());
  double friction[3] = { 0.0, 0.0, 0.0 };
  // The hand is steered back and forth until the newest tick slides along x, which may take a while
  // on a loaded machine.
  bool felt = false;
  for (int i = 0; i < 20000 && !felt; ++i)
  {
    const double there = i % 400 < 200 ? i % 200 : 200 - i % 200;
    const double tip[3] = { 0.3 + 0.02 * there, 0.2, -0.5 };
    session->GetDevice()->SteerTo(tip);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    session->GetFrictionForce(friction);
    felt = vtkMath::Norm(friction) > 0.99 * Friction * 3.45;
  }
  PALPATE_CHECK(felt);
  PALPATE_CHECK(std::abs(friction[1]) < 1e-9 && std::abs(friction[2]) < 1e-9);
  session->Stop();
}

/// There is one warning for each state of the body.
void checkUnsoundBody(vtkPolyData* sound)
{
  Body body = Body::New();
  body->DeepCopy(sound);
  body->GetPolys()->ReverseCellAtId(7);
  vtkNew<vtkHapticSession> session;
  Messages messages(session);
  session->SetBody(sound);
  session->GetDevice()->SetPath(draggedPath());
  PALPATE_CHECK(session->Start() && messages.none());
  session->SetBody(body);
  PALPATE_CHECK(session->Start());
  PALPATE_CHECK_TEXT(
    messages.warnings(), "1 triangle wound inward or against its neighbours: turned over");
  messages.clear();
  PALPATE_CHECK(session->Start() && messages.none());
  body->GetPoints()->Modified();
  PALPATE_CHECK(session->Start());
  PALPATE_CHECK_TEXT(messages.warnings(), "1 triangle wound inward or against its neighbours");
}
} // namespace

int TestHapticSessionSettings(int, char*[])
{
  const Body body = withResponse(planeBody(10.0, 10), "flat:1");
  checkDefaults();
  checkRefused(body);
  checkFrictionIsTold(body);
  checkFrictionChange(body);
  checkRealTime(body);
  checkUnsoundBody(body);
  return palpate::testing::result();
}
