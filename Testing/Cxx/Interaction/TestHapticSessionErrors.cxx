// SPDX-License-Identifier: BSD-3-Clause
// Each reason that prevents a start is named, and the session is not left partly started.
#include "Response/FilterChecks.h"
#include "SceneBodies.h"
#include "Haptics/Servo/ServoStep.h"

#include "vtkHapticSession.h"

namespace
{
using namespace palpate::testing;

void checkRefused(
  vtkHapticSession* session, Messages& messages, std::initializer_list<const char*> words)
{
  PALPATE_CHECK(!session->Start());
  const std::string text = messages.takeErrors();
  for (const char* word : words)
  {
    PALPATE_CHECK_TEXT(text, word);
  }
  PALPATE_CHECK(session->GetState() == vtkHapticSession::Stopped);
  session->Step(1.0);
  PALPATE_CHECK(
    session->GetRecorder()->GetTicks().empty() && session->GetDevice()->GetPathDuration() == 0.0);
}

void checkDevices(vtkHapticSession* session)
{
  Messages messages(session->GetDevice());
  for (const char* device :
    { "Simulated", "", "hid", "hid:", "replay:", "bridge:", "plant:", "mouse:0" })
  {
    PALPATE_CHECK(!session->GetDevice()->Open(device));
    PALPATE_CHECK_TEXT(messages.takeErrors(), device, "simulated", "hid:PATH");
  }
  for (const char* device : { "hid:/dev/nowhere", "replay:nowhere.csv", "bridge:nowhere" })
  {
    PALPATE_CHECK(!session->GetDevice()->Open(device));
    PALPATE_CHECK_TEXT(messages.takeErrors(), device, "nowhere");
  }
  PALPATE_CHECK(!session->GetDevice()->Open("plant:weight=1"));
  PALPATE_CHECK_TEXT(messages.takeErrors(), "plant:weight=1", "'weight'", "mass (kg)");
  PALPATE_CHECK(session->GetDevice()->Open("simulated") && messages.none());
}

void checkPaths(vtkHapticSession* session, Messages& messages, vtkPolyData* good)
{
  session->GetDevice()->SetPath(nullptr);
  checkRefused(session, messages, { "path", "Time" });
  Body path = Body::New();
  path->CopyStructure(good);
  session->GetDevice()->SetPath(path);
  checkRefused(session, messages, { "path", "Time" });
  path->DeepCopy(good);
  vtkDataArray* time = path->GetPointData()->GetArray("Time");
  time->SetTuple1(3, time->GetTuple1(2) - 0.1);
  checkRefused(session, messages, { "Point 3 of the path", "back in time" });
  time->SetTuple1(3, std::nan(""));
  checkRefused(session, messages, { "Point 3 of the path", "not finite" });
  // Two points at the same time are a jump, which is allowed.
  time->SetTuple1(3, time->GetTuple1(2));
  PALPATE_CHECK(session->Start());
  path->DeepCopy(good);
  path->GetPoints()->SetPoint(4, 0.0, std::numeric_limits<double>::infinity(), 0.0);
  checkRefused(session, messages, { "Point 4 of the path", "not finite" });
  session->GetDevice()->SetPath(Body::New());
  checkRefused(session, messages, { "path" });
}

void checkBodies(vtkHapticSession* session, Messages& messages, vtkPolyData* good)
{
  session->SetBody(nullptr);
  checkRefused(session, messages, { "body", "SetBody" });
  session->SetBody(planeBody(10.0, 4));
  checkRefused(session, messages, { "Wrong body", "Response" });
  session->SetBody(Body::New());
  checkRefused(session, messages, { "Wrong body" });
  session->SetBody(good);
  session->SetResponseName("Elsewhere");
  checkRefused(session, messages, { "Wrong body", "Elsewhere" });
  session->SetResponseName("Response");
  PALPATE_CHECK(session->Start());
  session->SetBody(planeBody(10.0, 4)); // a refused start also ends the previous run
  checkRefused(session, messages, { "Wrong body" });
  session->SetBody(good);
}
} // namespace

int TestHapticSessionErrors(int, char*[])
{
  const Body body = withResponse(planeBody(10.0, 10), "sphere:2");
  const Body path = slidePath(body, { 0.0, 0.0, 1.0 }, { 0.0, 0.0, 1.0 }, 1.0);
  vtkNew<vtkHapticSession> session;
  Messages messages(session);
  session->GetDevice()->SetPath(path);
  checkDevices(session);
  checkBodies(session, messages, body);
  checkPaths(session, messages, path);
  session->GetDevice()->SetPath(path);
  PALPATE_CHECK(session->Start());
  session->SetRate(0.0);
  PALPATE_CHECK(session->GetRate() == 1.0);
  session->SetRate(1e9);
  PALPATE_CHECK(session->GetRate() == 100000.0);
  PALPATE_CHECK(messages.none());
  return palpate::testing::result();
}
