// SPDX-License-Identifier: BSD-3-Clause
// A session in a scene: its newest tick, its trail, and the scale of its forces.
#include "vtkContactScene.h"

#include "Haptics/Servo/TickHistory.h"
#include "Interaction/Display/ForceTrail.h"
#include "Interaction/Display/SceneCaption.h"
#include "Interaction/Display/SceneLegends.h"
#include "Interaction/Display/ScaleRule.h"
#include "Interaction/Display/ShownContact.h"
#include "Interaction/Display/ShownHands.h"
#include "vtkFrameClock.h"
#include "vtkHapticRecorder.h"
#include "vtkHapticSession.h"

#include "vtkLookupTable.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace
{
// Priority among the observers of a frame. The scene is the last observer that is called.
constexpr float LastPriority = -1.0F;
constexpr double PassedSeconds = 2.0; // longest time between two pictures that the trail bridges, s
constexpr double RemarkSeconds = 3.0; // time for which a picture says that its scale has changed, s

std::string joinedLines(const std::string& first, const std::string& second)
{
  return first + (first.empty() || second.empty() ? "" : "\n") + second;
}
} // namespace

void vtkContactScene::Follow(vtkFrameClock* clock, vtkHapticSession* session)
{
  if (this->Clock)
  {
    this->Clock->RemoveObserver(this->FrameObserver);
  }
  if (session)
  {
    vtkHapticRecorder* recorder = session->GetRecorder();
    recorder->SetHistorySeconds(std::max(recorder->GetHistorySeconds(), PassedSeconds));
  }
  this->Clock = session ? clock : nullptr;
  this->Followed = session;
  if (this->Clock)
  {
    this->FrameObserver = this->Clock->AddObserver(
      vtkFrameClock::FrameEvent, this, &vtkContactScene::ShowFrame, LastPriority);
  }
}

void vtkContactScene::ShowFrame()
{
  this->ShowSession(this->Followed);
}

void vtkContactScene::SetFreeDirection(int hand, const double direction[3])
{
  if (hand >= 0)
  {
    this->Hands->setFreeDirection(static_cast<std::size_t>(hand), Eigen::Vector3d(direction));
  }
}

void vtkContactScene::ShowSession(vtkHapticSession* session)
{
  std::vector<palpate::ShownContact> contacts;
  this->Hands->resize(static_cast<std::size_t>(session->GetNumberOfDevices()));
  for (std::size_t i = 0; i < this->Hands->count(); ++i)
  {
    contacts.push_back(
      palpate::readSession(session, static_cast<int>(i), this->Hands->freeDirection(i)));
  }
  this->PassTicks(session, contacts.front().tick.time);
  this->Trail->follow(contacts.front(), static_cast<std::size_t>(this->TrailLength));
  this->FitForceScale(contacts.front());
  this->SwitchTrail();
  this->Hands->setSteadyLabels(true);
  this->Caption->setState(
    this->Blind ? std::string() : joinedLines(session->GetReplayText(), this->Notice));
  this->Show(contacts);
}

/// Adds to the trail the contacts since the last picture, up to the time `until` (s).
void vtkContactScene::PassTicks(vtkHapticSession* session, double until)
{
  const palpate::TickHistory& ticks = session->GetRecorder()->GetLastTicks();
  if (this->TrailRun != session->GetNumberOfStarts())
  {
    this->TrailRun = session->GetNumberOfStarts();
    this->TrailSeen = 0;
  }
  const std::uint64_t oldest = ticks.added() - ticks.size();
  std::uint64_t number = std::max<std::uint64_t>(this->TrailSeen, oldest);
  for (; number < ticks.added(); ++number)
  {
    const palpate::Tick& tick = ticks[static_cast<std::size_t>(number - oldest)];
    if (!(tick.time < until))
    {
      break;
    }
    if (tick.contact.triangle < 0)
    {
      this->Trail->lift();
    }
    else if (this->Trail->isFar(tick.contact.contactPoint))
    {
      this->Trail->pass(palpate::contactOfTick(session, tick));
    }
  }
  this->TrailSeen = number;
}

/// Adapts the scale of the arrows and the colours of the trail to the force of a contact.
void vtkContactScene::FitForceScale(const palpate::ShownContact& contact)
{
  const double time = contact.tick.time;
  const double force = contact.touches() ? contact.tick.idealForce.norm() : 0.0;
  const double largest = std::max(force, this->Trail->largestForce());
  const double end = this->Legends->forceColors()->GetRange()[1];
  if (this->ForceRule->mustChange(
        largest, end, contact.touches() ? time : std::numeric_limits<double>::quiet_NaN()))
  {
    this->SetLargestForce(largest);
  }
  if (this->IsScaleNew && this->HasShownSession)
  {
    this->ScaleTime = time;
  }
  this->IsScaleNew = false;
  this->HasShownSession = true;
  this->Scale->setChanged(this->ScaleTime <= time && time < this->ScaleTime + RemarkSeconds);
}
