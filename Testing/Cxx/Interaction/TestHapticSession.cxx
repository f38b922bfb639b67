// SPDX-License-Identifier: BSD-3-Clause
// Virtual time: steps add up, the same steps give the same bits, a stopped session exerts no force,
// the force of the device is limited, and the hand rests at the end of a path.
#include "Response/FilterChecks.h"
#include "SceneBodies.h"
#include "Haptics/Servo/ServoStep.h"

#include "vtkHapticSession.h"

#include <cstring>
#include <vector>

namespace
{
using namespace palpate::testing;

vtkSmartPointer<vtkHapticSession> startedSession(vtkPolyData* body, vtkPolyData* path)
{
  auto session = vtkSmartPointer<vtkHapticSession>::New();
  session->SetBody(body);
  PALPATE_CHECK(session->GetDevice()->Open("simulated"));
  session->GetDevice()->SetPath(path);
  PALPATE_CHECK(session->GetState() == vtkHapticSession::Stopped);
  PALPATE_CHECK(session->Start());
  PALPATE_CHECK(session->GetState() == vtkHapticSession::Running);
  return session;
}

bool sameBits(const palpate::Tick& a, const palpate::Tick& b)
{
  const auto same = [](const Eigen::Vector3d& u, const Eigen::Vector3d& v)
  { return std::memcmp(u.data(), v.data(), sizeof(double) * 3) == 0; };
  return a.time == b.time && same(a.tip, b.tip) && same(a.deviceForce, b.deviceForce) &&
    same(a.contact.force, b.contact.force) &&
    same(a.contact.contactPoint, b.contact.contactPoint) &&
    a.contact.deflection == b.contact.deflection && a.contact.triangle == b.contact.triangle &&
    a.contact.state == b.contact.state;
}

void checkSameTicks(vtkHapticSession* one, vtkHapticSession* other)
{
  PALPATE_CHECK(one->GetRecorder()->GetTicks().size() == other->GetRecorder()->GetTicks().size());
  for (std::size_t i = 0;
       i < std::min(one->GetRecorder()->GetTicks().size(), other->GetRecorder()->GetTicks().size());
       ++i)
  {
    PALPATE_CHECK(sameBits(one->GetRecorder()->GetTicks()[i], other->GetRecorder()->GetTicks()[i]));
  }
}

void checkSteps(vtkPolyData* body, vtkPolyData* path)
{
  const auto whole = startedSession(body, path);
  whole->Step(1.0);
  PALPATE_CHECK(whole->GetRecorder()->GetTicks().size() == 1000);
  PALPATE_CHECK_NEAR(whole->GetTime(), 1.0, 1e-12);
  // Steps of whole ticks, of display frames, and of less than a tick.
  for (const int pieces : { 10, 1000, 60, 144, 2500, 7000 })
  {
    const auto session = startedSession(body, path);
    for (int i = 0; i < pieces; ++i)
    {
      session->Step(1.0 / pieces);
    }
    checkSameTicks(session, whole);
  }
  for (const double nothing : { 0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    whole->Step(nothing);
    PALPATE_CHECK(whole->GetRecorder()->GetTicks().size() == 1000);
  }
  for (std::size_t i = 0; i < 1000; ++i)
  {
    PALPATE_CHECK_NEAR(
      whole->GetRecorder()->GetTicks()[i].time, 0.001 * static_cast<double>(i), 1e-15);
  }
  const auto slow = startedSession(body, path);
  slow->Stop();
  slow->SetRate(250.0);
  PALPATE_CHECK(slow->Start());
  slow->Step(1.0);
  PALPATE_CHECK(slow->GetRecorder()->GetTicks().size() == 250);
  PALPATE_CHECK(
    sameBits(slow->GetRecorder()->GetTicks()[200], whole->GetRecorder()->GetTicks()[800]));
}

void checkStop(vtkPolyData* body, vtkPolyData* path)
{
  const auto session = startedSession(body, path);
  PALPATE_CHECK(session->GetRecorder()->GetTicks().empty() && session->GetDeflection() == 0.0);
  session->Step(1.3);
  double force[3];
  double ideal[3];
  session->GetForce(force);
  session->GetIdealForce(ideal);
  PALPATE_CHECK(vtkMath::Norm(force) > 0.1 && std::equal(force, force + 3, ideal));
  PALPATE_CHECK(session->GetContactState() == 2 && session->GetDeflection() > 0.9);
  session->Stop();
  PALPATE_CHECK(session->GetState() == vtkHapticSession::Stopped);
  session->GetForce(force);
  PALPATE_CHECK(vtkMath::Norm(force) == 0.0);
  session->Step(1.0);
  PALPATE_CHECK(session->GetRecorder()->GetTicks().size() == 1300); // ticks are kept after Stop
  PALPATE_CHECK(session->Start());                                  // starts again at time 0
  PALPATE_CHECK(session->GetRecorder()->GetTicks().empty() && session->GetTime() == 0.0);
  session->GetForce(force);
  PALPATE_CHECK(vtkMath::Norm(force) == 0.0);
}

/// The body is so stiff that the device, with its limit of 10 N, cannot apply the force.
void checkLimit(vtkPolyData* path)
{
  const auto session = startedSession(withResponse(planeBody(20.0, 20), "flat:3"), path);
  session->Step(1.3);
  double force[3];
  double ideal[3];
  session->GetForce(force);
  session->GetIdealForce(ideal);
  const double wanted = vtkMath::Norm(ideal);
  PALPATE_CHECK_NEAR(wanted, 2.0 * 3.45 * 3.0, 0.01);
  for (int k = 0; k < 3; ++k)
  {
    PALPATE_CHECK_NEAR(force[k], ideal[k] * 10.0 / wanted, 1e-12);
  }
}

void checkRest(vtkPolyData* body, vtkPolyData* path)
{
  const auto session = startedSession(body, path);
  const double duration = session->GetDevice()->GetPathDuration();
  double last[3];
  path->GetPoint(path->GetNumberOfPoints() - 1, last);
  PALPATE_CHECK_NEAR(duration,
    path->GetPointData()->GetArray("Time")->GetTuple1(path->GetNumberOfPoints() - 1), 0.0);
  session->Step(duration + 0.5);
  for (std::size_t i = 0; i < 400; ++i)
  {
    const auto& tick =
      session->GetRecorder()->GetTicks()[session->GetRecorder()->GetTicks().size() - 1 - i];
    for (int k = 0; k < 3; ++k)
    {
      PALPATE_CHECK_NEAR(tick.tip[k], last[k], 1e-12); // converted from mm to m and back
    }
    PALPATE_CHECK(tick.contact.triangle < 0 && tick.contact.force.norm() == 0.0);
  }
}
} // namespace

int TestHapticSession(int, char*[])
{
  const Body body = withResponse(planeBody(20.0, 20), "sphere:2");
  const Body path = slidePath(body, { 0.0, 0.0, 1.0 }, { 0.0, 0.0, 1.0 }, 1.0);
  checkSteps(body, path);
  checkStop(body, path);
  checkLimit(path);
  checkRest(body, path);
  return palpate::testing::result();
}
