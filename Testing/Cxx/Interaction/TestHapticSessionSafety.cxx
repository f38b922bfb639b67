// SPDX-License-Identifier: BSD-3-Clause
// The links between the ideal force and the hand: devices weaker than the tool, limits, the gate,
// and changes of the tool during contact.
#include "PlacedDevice.h"
#include "Haptics/Servo/ServoStep.h"

#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

namespace
{
using namespace palpate::testing;

/// The paper's tools, 1 mm deep. A device limited to 2 N/mm equalises their forces at about 2 N;
/// one common factor preserves their ratios. The forces, uncapped and capped, are those of the
/// project's reference: 11.4, 11.0, 5.45 N and 1.99, 2.00, 1.96 N.
void checkFit(vtkPolyData* body)
{
  double capped[3];
  double fitted[3];
  double ideal[3];
  const char* const names[3] = { "Flat", "Sphere", "Small" };
  for (int i = 0; i < 3; ++i)
  {
    vtkNew<vtkHapticSession> session;
    session->SetBody(body);
    session->SetResponseName(names[i]);
    pressed(session, deviceOf(10.0, 2000.0));
    ideal[i] = idealOf(session);
    capped[i] = appliedTo(session);
    PALPATE_CHECK(session->GetForceFactor() == 1.0);
    PALPATE_CHECK_TEXT(session->GetSafetyText(), "stiffness capped");

    session->Stop();
    session->GetSafety()->FitForceOn();
    session->GetSafety()->SetFitDepth(1.0);
    for (const char* name : names)
    {
      session->GetSafety()->AddFitResponse(name);
    }
    pressed(session, deviceOf(10.0, 2000.0));
    fitted[i] = appliedTo(session);
    PALPATE_CHECK(idealOf(session) == ideal[i]);
    PALPATE_CHECK_NEAR(fitted[i], session->GetForceFactor() * ideal[i], 1e-6);
    PALPATE_CHECK_TEXT(session->GetSafetyText(), "force \u00d70.1", "too soft", "2 N/mm");
    PALPATE_CHECK_TEXT(session->GetFitReason(), "too soft");
  }
  // The larger sphere, 1 mm deep, has the largest stiffness.
  const double factor = 2.0 / makeTool("sphere:6.35")->GetStiffness(1.0, 3.45);
  const double reference[3] = { 11.04, 11.4, 5.45 };
  const double referenceCapped[3] = { 2.00, 1.99, 1.96 };
  for (int i = 0; i < 3; ++i)
  {
    PALPATE_CHECK_NEAR(ideal[i], reference[i], 0.05); // reference values have three digits
    PALPATE_CHECK_NEAR(capped[i], referenceCapped[i], 0.005 + 1e-9);
    // Tolerance for the stored curves.
    PALPATE_CHECK_NEAR(fitted[i] / ideal[i], factor, 1e-3 * factor);
  }
  for (int i = 0; i < 3; ++i)
  {
    PALPATE_CHECK_NEAR(fitted[i] / fitted[1], ideal[i] / ideal[1], 1e-6);
  }
  PALPATE_CHECK(fitted[2] / fitted[1] < 0.5);
}

/// A simulated hand without a force limit renders each force unchanged, also with the fit.
void checkNoFit(vtkPolyData* body)
{
  vtkNew<vtkHapticSession> session;
  session->SetBody(body);
  session->SetResponseName("Flat");
  session->RealTimeOn();
  session->GetSafety()->FitForceOn();
  session->GetSafety()->SetFitDepth(2.0);
  const double point[3] = { 0.3, 0.2, 0.0 };
  const double normal[3] = { 0.0, 0.0, 1.0 };
  for (const double limit : { 10.0, std::numeric_limits<double>::infinity() })
  {
    session->GetDevice()->SetSimulatedForce(limit);
    session->GetDevice()->TouchAt(point, normal, 3.0);
    PALPATE_CHECK(session->Start());
    session->GetDevice()->TouchAt(point, normal, -2.0);
    for (int i = 0; i < 60000 && session->GetDeflection() < 1.9999; ++i)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    const palpate::Tick tick = session->GetNewestTick();
    PALPATE_CHECK(tick.idealForce.norm() > 20.0);
    PALPATE_CHECK((tick.forceFactor < 1.0) == std::isfinite(limit));
    PALPATE_CHECK((tick.appliedForce == tick.idealForce) != std::isfinite(limit));
    PALPATE_CHECK(session->GetFitReason().empty() != std::isfinite(limit));
    PALPATE_CHECK(session->GetSafetyText().empty() != std::isfinite(limit));
    session->Stop();
  }
}

/// A force limit in addition to the device's limit, and errors that name the property.
void checkLimits(vtkPolyData* body)
{
  vtkNew<vtkHapticSession> session;
  session->SetBody(body);
  session->SetResponseName("Sphere");
  session->GetSafety()->StiffnessCapOff();
  session->GetSafety()->SetForceLimit(1.5);
  pressed(session, deviceOf(10.0, 2000.0));
  PALPATE_CHECK_NEAR(appliedTo(session), 1.5, 1e-12);
  PALPATE_CHECK_TEXT(session->GetSafetyText(), "largest");
  Messages messages(session);
  vtkHapticSafety* safety = session->GetSafety();
  vtkHapticDevice* device = session->GetDevice();
  const auto refused = [&](const char* word)
  {
    PALPATE_CHECK(!session->Start());
    PALPATE_CHECK_TEXT(messages.takeErrors(), word);
    PALPATE_CHECK(session->GetState() == vtkHapticSession::Stopped);
  };
  safety->SetForceLimit(std::nan(""));
  refused("Maximum Force");
  safety->SetForceLimit(1.5);
  safety->SetEntryRamp(-1.0);
  refused("Entry Ramp");
  safety->SetEntryRamp(0.0);
  device->SetScale(0.0);
  refused("Scale");
  device->SetScale(1.0);
  device->SetUp(1.0, 1.0, 0.0); // not perpendicular to x
  refused("Rotation");
  device->SetUp(0.0, 1.0, 0.0);
  safety->FitForceOn();
  safety->SetFitDepth(0.0);
  refused("FitDepth");
  safety->SetFitDepth(1.0);
  safety->AddFitResponse("Elsewhere");
  refused("Elsewhere");
  safety->ClearFitResponses();
  Messages refusals(device);
  device->Use(nullptr);
  PALPATE_CHECK_TEXT(refusals.takeErrors(), "null");
  PALPATE_CHECK(session->Start() && messages.none());
}

/// The limits of torque for a device that outputs torque: the smaller value of its own limits and
/// the settings.
void checkTorqueLimits()
{
  palpate::DeviceSpecification device;
  device.outputsTorque = true;
  device.maximumTorque = 0.2;
  device.maximumTorsionalStiffness = 0.4;
  vtkNew<vtkHapticSafety> safety;
  PALPATE_CHECK(safety->GetSettings(device, false).maximumTorque == 0.2);
  PALPATE_CHECK(safety->GetSettings(device, false).maximumTorsionalStiffness == 0.4);
  safety->SetTorqueLimit(0.05);
  safety->SetTorsionalStiffnessLimit(0.1);
  PALPATE_CHECK(safety->GetSettings(device, false).maximumTorque == 0.05);
  PALPATE_CHECK(safety->GetSettings(device, false).maximumTorsionalStiffness == 0.1);
  safety->SetTorqueLimit(0.3);
  PALPATE_CHECK(safety->GetSettings(device, false).maximumTorque == 0.2);
  // The device has no torque output.
  PALPATE_CHECK(safety->GetSettings({}, false).maximumTorque == 0.0);
}

void checkGate(vtkPolyData* body)
{
  vtkNew<vtkHapticSession> session;
  session->SetBody(body);
  session->SetResponseName("Flat");
  for (const bool gate : { true, false })
  {
    auto owned = std::make_unique<PlacedDevice>(deviceOf(100.0, 1e6));
    PlacedDevice* device = owned.get();
    device->Height = -1e-3; // inside the body from the start
    session->GetDevice()->Use(std::move(owned));
    session->GetSafety()->PassivityControlOff();
    session->GetSafety()->SetGate(gate);
    PALPATE_CHECK(session->Start());
    session->Step(0.1);
    PALPATE_CHECK(idealOf(session) > 11.0);
    PALPATE_CHECK((appliedTo(session) == 0.0) == gate);
    PALPATE_CHECK((device->Force == 0.0) == gate);
    device->Height = 1e-3;
    session->Step(0.01);
    device->Height = -1e-3;
    session->Step(0.01);
    PALPATE_CHECK_NEAR(appliedTo(session), idealOf(session), 1e-12);
  }
}

/// A change of the tool during contact causes neither a restart nor a jump of the force.
void checkChange(vtkPolyData* body)
{
  vtkNew<vtkHapticSession> session;
  session->SetBody(body);
  session->SetResponseName("Flat");
  PlacedDevice* device = pressed(session, deviceOf(100.0, 1e6));
  const double before = device->Force;
  const double time = session->GetTime();
  session->SetResponseName("Small");
  PALPATE_CHECK(session->ApplyChanges());
  double last = before;
  double largest = 0.0;
  for (int i = 0; i < 60; ++i)
  {
    session->Step(0.001);
    largest = std::max(largest, std::abs(device->Force - last));
    last = device->Force;
  }
  PALPATE_CHECK_NEAR(session->GetTime(), time + 0.06, 1e-12);
  vtkNew<vtkHapticSession> alone;
  alone->SetBody(body);
  alone->SetResponseName("Small");
  PALPATE_CHECK_NEAR(last, pressed(alone, deviceOf(100.0, 1e6))->Force, 1e-12);
  // The change is linear in time over 50 ms: 50 equal steps of 1 ms. The tolerance of 1 % is for
  // the rounding of the ramp.
  PALPATE_CHECK_NEAR(largest, (before - last) / 50.0, 0.01 * (before - last) / 50.0);
  PALPATE_CHECK(session->GetRecorder()->GetTicks().back().scene == 1);

  // An invalid change is refused with its name, and the session continues.
  Messages messages(session);
  session->SetResponseName("Elsewhere");
  PALPATE_CHECK(!session->ApplyChanges());
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Elsewhere");
  session->SetResponseName("Small");
  session->GetSettings()->SetFrictionCoefficient(-1.0);
  PALPATE_CHECK(!session->ApplyChanges());
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Friction Coefficient");
  session->GetSettings()->SetFrictionCoefficient(0.0);
  session->Step(0.1);
  PALPATE_CHECK(device->Force == last && session->GetRecorder()->GetTicks().back().scene == 1);
  // The new body is 2 mm lower, so the tip is outside.
  Body lower = Body::New();
  lower->DeepCopy(body);
  for (vtkIdType i = 0; i < lower->GetNumberOfPoints(); ++i)
  {
    double x[3];
    lower->GetPoint(i, x);
    lower->GetPoints()->SetPoint(i, x[0], x[1], x[2] - 2.0);
  }
  session->SetBody(lower);
  PALPATE_CHECK(session->ApplyChanges());
  session->Step(0.06);
  PALPATE_CHECK(device->Force == 0.0 && session->GetContactCell() == -1 && messages.none());
  session->Stop();
  PALPATE_CHECK(session->ApplyChanges()); // no effect on a stopped session
}
} // namespace

int TestHapticSessionSafety(int, char*[])
{
  const Body body = threeTools();
  checkFit(body);
  checkNoFit(body);
  checkLimits(body);
  checkTorqueLimits();
  checkGate(body);
  checkChange(body);
  return palpate::testing::result();
}
