// SPDX-License-Identifier: BSD-3-Clause
// A device that the force moves. In free space it is a mass on a spring and damper; in contact it
// comes to equilibrium. It is stable with the safety chain and unstable without. It is steered by a
// path and by hand.
#include "PlacedDevice.h"
#include "Haptics/Servo/ServoStep.h"

#include "vtkDoubleArray.h"
#include "vtkPoints.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace
{
using namespace palpate::testing;

/// The target of the hand over the middle of a triangle's edge, as pairs {time, height in mm}.
Body heights(const std::vector<std::pair<double, double>>& places)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> times;
  times->SetName("Time");
  for (const auto& [time, height] : places)
  {
    points->InsertNextPoint(0.3, 0.2, height);
    times->InsertNextValue(time);
  }
  Body path = Body::New();
  path->SetPoints(points);
  path->GetPointData()->AddArray(times);
  return path;
}

void prepare(vtkHapticSession* session, vtkPolyData* body, const char* response, vtkPolyData* path,
  const std::string& device)
{
  session->SetBody(body);
  session->SetResponseName(response);
  session->GetDevice()->SetPath(path);
  PALPATE_CHECK(session->GetDevice()->Open(device));
  PALPATE_CHECK(session->GetDevice()->IsSimulated() && !session->GetDevice()->IsPhysical());
  PALPATE_CHECK(!session->GetDevice()->GetOutputsForce()); // no person holds the device
  PALPATE_CHECK(session->GetDevice()->GetMaximumForce() == 10.0);
}

/// The target of the hand jumps by 10 mm, in the air. The result is the step response of m x'' + (b
/// + b_h) x' + k x.
void checkFree(vtkPolyData* body)
{
  vtkNew<vtkHapticSession> session;
  prepare(session, body, "Flat", heights({ { 0.0, 60.0 }, { 0.1, 60.0 }, { 0.1, 50.0 } }),
    "plant:mass=0.2,damping=1,stiffness=500,hand-damping=2");
  PALPATE_CHECK(session->Start());
  session->Step(0.5);
  const double decay = (1.0 + 2.0) / (2.0 * 0.2);
  const double omega = std::sqrt(500.0 / 0.2 - decay * decay);
  PALPATE_CHECK(session->GetRecorder()->GetTicks().size() == 500);
  for (const palpate::Tick& tick : session->GetRecorder()->GetTicks())
  {
    const double t = std::max(0.0, tick.time - 0.1);
    const double left =
      std::exp(-decay * t) * (std::cos(omega * t) + decay / omega * std::sin(omega * t));
    PALPATE_CHECK_NEAR(tick.tip.z(), 50.0 + 10.0 * left, 1e-9); // mm; rounding of 500 ticks
    PALPATE_CHECK(tick.appliedForce.isZero());
  }
}

/// The target is 1 mm below the surface. The hand comes to rest where the contact force is k
/// (x_hand - x).
void checkEquilibrium(vtkPolyData* body)
{
  // With 20 N s/m the stiffness cap is 40 N/mm. The contact of the sphere is less stiff, so it is
  // not capped.
  vtkNew<vtkHapticSession> session;
  prepare(session, body, "Sphere", heights({ { 0.0, 5.0 }, { 1.0, -1.0 } }),
    "plant:damping=20,stiffness=1000");
  PALPATE_CHECK(session->Start());
  session->Step(4.0);
  const palpate::Tick& last = session->GetRecorder()->GetTicks().back();
  PALPATE_CHECK(last.contact.deflection > 0.05 && last.contact.deflection < 0.5);
  PALPATE_CHECK_NEAR(last.contact.deflection, -last.tip.z(), 1e-12);
  PALPATE_CHECK_NEAR(last.appliedForce.z(), 1000.0 * 1e-3 * (last.tip.z() + 1.0), 1e-9); // N
  PALPATE_CHECK_NEAR((last.appliedForce - last.contact.force).norm(), 0.0, 1e-12);
  // The same steps give the same bits.
  vtkNew<vtkHapticSession> again;
  prepare(again, body, "Sphere", heights({ { 0.0, 5.0 }, { 1.0, -1.0 } }),
    "plant:stiffness=1000,damping=20");
  PALPATE_CHECK(again->Start());
  for (int i = 0; i < 16; ++i)
  {
    again->Step(0.25);
  }
  PALPATE_CHECK(
    again->GetRecorder()->GetTicks().size() == session->GetRecorder()->GetTicks().size());
  for (std::size_t i = 0; i < again->GetRecorder()->GetTicks().size(); ++i)
  {
    PALPATE_CHECK(
      again->GetRecorder()->GetTicks()[i].tip == session->GetRecorder()->GetTicks()[i].tip);
    PALPATE_CHECK(again->GetRecorder()->GetTicks()[i].appliedForce ==
      session->GetRecorder()->GetTicks()[i].appliedForce);
  }
}

struct Rest
{
  double sway = 0.0;  ///< peak-to-peak motion of the tip in the last half second, mm
  double force = 0.0; ///< force at the end, N
  double depth = 0.0; ///< depth at the end, mm
};

/// The flat punch has 11 N/mm. The plant with 0.1 kg and 1 N s/m at 1 kHz is stable up to 2 N/mm,
/// and up to 3 N/mm in this hand. The specification of the plant states half of the first value.
Rest pressStiff(vtkPolyData* body, bool isCapped, bool isPassive)
{
  vtkNew<vtkHapticSession> session;
  prepare(session, body, "Flat", heights({ { 0.0, 2.0 }, { 1.0, -2.0 } }),
    "plant:stiffness=300,hand-damping=0.5");
  session->GetSafety()->SetStiffnessCap(isCapped);
  session->GetSafety()->SetPassivityControl(isPassive);
  PALPATE_CHECK(session->Start());
  session->Step(5.0);
  const auto& ticks = session->GetRecorder()->GetTicks();
  double least = ticks.back().tip.z();
  double most = least;
  for (std::size_t i = ticks.size() - 500; i < ticks.size(); ++i)
  {
    least = std::min(least, ticks[i].tip.z());
    most = std::max(most, ticks[i].tip.z());
  }
  return { most - least, ticks.back().appliedForce.z(), ticks.back().contact.deflection };
}

void checkSafety(vtkPolyData* body)
{
  const Rest loose = pressStiff(body, false, false);
  PALPATE_CHECK(loose.sway > 0.05);
  const Rest capped = pressStiff(body, true, false);
  PALPATE_CHECK(capped.sway < 1e-3);
  PALPATE_CHECK_NEAR(capped.force, 1.0 * capped.depth, 1e-6); // the allowed stiffness b/T is 1 N/mm
  const Rest passive = pressStiff(body, false, true);
  PALPATE_CHECK(passive.sway < 0.1 * loose.sway);
  const Rest both = pressStiff(body, true, true);
  PALPATE_CHECK(both.sway < 1e-3);
  PALPATE_CHECK(both.force == capped.force); // a stable spring is not changed
}

/// On the servo thread the hand moves to its target, and the body stops it.
void checkSteered(vtkPolyData* body)
{
  vtkNew<vtkHapticSession> session;
  prepare(session, body, "Flat", nullptr, "plant");
  session->RealTimeOn();
  const double above[3] = { 0.3, 0.2, 3.0 };
  const double below[3] = { 0.3, 0.2, -2.0 };
  session->GetDevice()->SteerTo(above);
  PALPATE_CHECK(session->Start());
  session->GetDevice()->SteerTo(below);
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  double tip[3] = { 0.0, 0.0, 3.0 };
  while (!(tip[2] < 0.0 && appliedTo(session) > 0.1) && std::chrono::steady_clock::now() < end)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    session->GetTip(tip);
  }
  PALPATE_CHECK(tip[2] < 0.0 && tip[2] > -2.0);
  PALPATE_CHECK(appliedTo(session) > 0.1);
  session->Stop();
}
} // namespace

int TestHapticSessionPlant(int, char*[])
{
  const Body body = threeTools();
  checkFree(body);
  checkEquilibrium(body);
  checkSafety(body);
  checkSteered(body);
  return palpate::testing::result();
}
