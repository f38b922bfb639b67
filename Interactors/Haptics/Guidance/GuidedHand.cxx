// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Guidance/GuidedHand.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double AtEnd = 1e-10;   // mm; a shorter remaining path counts as finished
constexpr double Rounding = 1e-9; // mm, tolerance of a depth

bool isSamePlace(const TouchGoal& goal, const TouchGoal& other) noexcept
{
  return goal.surface == other.surface && goal.point == other.point &&
    goal.normal == other.normal && goal.hover == other.hover;
}
} // namespace

void GuidedHand::putAt(const Vector3& tip) noexcept
{
  this->Tip = tip;
  this->Now = Phase::Lost;
  this->IsSearching = false;
  this->Path.count = 0;
  this->Tracker.reset();
  this->Depth = 0.0;
  this->Goal.number = 0;
  this->Wanted.number = 0;
}

void GuidedHand::beginAt(const TouchGoal& goal) noexcept
{
  this->Wanted = goal;
  this->setGoal(goal);
  this->IsSearching = false;
  this->enterAtTop();
}

void GuidedHand::enterAtTop() noexcept
{
  this->Tracker->reset();
  this->Depth = 0.0;
  this->Tip = this->Goal.way[0];
  this->enterColumn();
}

/// Moves the tip within the column of Goal from its present position to the goal.
void GuidedHand::enterColumn() noexcept
{
  RouteSearch::Route route;
  route.add(this->Tip);
  route.add(this->Goal.tip());
  this->enter(route, 0);
}

void GuidedHand::follow(const TouchGoal& goal) noexcept
{
  if (goal.number != this->Wanted.number)
  {
    this->Wanted = goal;
  }
}

bool GuidedHand::rests() const noexcept
{
  return this->Goal.number == this->Wanted.number && this->Now == Phase::Moving &&
    !this->IsSearching && this->Tip == this->Path.last();
}

std::uint64_t GuidedHand::oldestBody() const noexcept
{
  std::uint64_t oldest = this->Wanted.bodyNumber;
  if (this->Goal.number > 0)
  {
    oldest = std::min(oldest, this->Goal.bodyNumber);
  }
  return this->IsSearching ? std::min(oldest, this->Search.goal().bodyNumber) : oldest;
}

void GuidedHand::advance(double elapsed) noexcept
{
  const double share = -std::expm1(-elapsed / TimeConstant);
  const double most = FastestSpeed * elapsed;
  if (!this->IsSearching && this->Wanted.number != this->Goal.number)
  {
    this->react();
  }
  if (this->IsSearching)
  {
    this->search();
  }
  if (this->Now == Phase::Sliding)
  {
    this->slide(share, most);
  }
  else if (this->Path.count > 0)
  {
    this->moveInContact(share, most);
  }
}

/// Chooses the path of the tip to the newest goal.
void GuidedHand::react() noexcept
{
  const TouchGoal& wanted = this->Wanted;
  if (this->Now == Phase::Lost || wanted.surface != this->Goal.surface)
  {
    this->Now = Phase::Lost;
    this->setGoal(wanted);
    this->depart();
    return;
  }
  if (this->canSlideTo(wanted))
  {
    if (this->Now == Phase::Moving)
    {
      this->Foot = this->Goal.point;
      this->FootNormal = this->Goal.normal;
      this->FootTriangle = this->Goal.triangle;
      this->Height = this->heightInColumn();
      this->Now = Phase::Sliding;
    }
    this->Stuck = 0;
    this->setGoal(wanted);
    return;
  }
  if (isSamePlace(wanted, this->Goal) && this->Now == Phase::Moving)
  {
    this->setGoal(wanted);
    if (!this->isInColumn())
    {
      this->Path.points[this->Path.count - 1] = wanted.tip();
      return;
    }
    if (wanted.presses() || this->canRise())
    {
      this->enterColumn();
      return;
    }
  }
  if (this->Now == Phase::Sliding || this->isInColumn() ||
    this->pointsToLeave() <= RouteSearch::MostRetreat)
  {
    this->depart();
  }
}

void GuidedHand::setGoal(const TouchGoal& goal) noexcept
{
  const bool isOther = !this->Tracker || this->Goal.body != goal.body;
  this->Goal = goal;
  if (isOther)
  {
    this->Tracker.emplace(goal.body->surface, goal.body->tree);
    this->acceptContact(*this->Tracker, this->Tracker->update(this->Tip));
  }
}

double GuidedHand::depthOf(const ContactTracker::Result& contact) noexcept
{
  using Outcome = ContactTracker::Outcome;
  const bool touches = contact.outcome == Outcome::Inside || contact.outcome == Outcome::Crease;
  return touches ? -contact.place.signedDistance : 0.0;
}

void GuidedHand::acceptContact(
  const ContactTracker& tracker, const ContactTracker::Result& contact) noexcept
{
  if (&tracker != &*this->Tracker)
  {
    this->Tracker.emplace(tracker);
  }
  this->Depth = depthOf(contact);
  this->ContactPoint = contact.place.projection.point;
  this->ContactNormal = this->Depth > 0.0
    ? surfaceNormal(*this->Goal.body, contact.place.triangle, contact.place.projection.weights)
    : Vector3(Vector3::Zero());
}

bool GuidedHand::isInColumn() const noexcept
{
  return this->Now == Phase::Moving && this->Leg + 2 >= this->Path.count;
}

bool GuidedHand::canSlideTo(const TouchGoal& goal) const noexcept
{
  const bool slides = this->Now == Phase::Sliding;
  constexpr double top = 0.999; // fraction of the column; a tip above the surface does not slide
  if (!goal.presses() || !this->Goal.presses() ||
    !(slides || (this->isInColumn() && this->heightInColumn() < top * this->Goal.hover)))
  {
    return false;
  }
  const Vector3& foot = slides ? this->Foot : this->Goal.point;
  const Vector3& normal = slides ? this->FootNormal : this->Goal.normal;
  return (goal.point - foot).norm() < std::min(SlideReach, 0.5 * goal.radius) &&
    goal.normal.dot(normal) > 0.0;
}

void GuidedHand::search() noexcept
{
  const FreeLine::State state = this->Search.go(SearchQueries);
  if (state == FreeLine::State::Unknown)
  {
    return;
  }
  this->IsSearching = false;
  this->setGoal(this->Search.goal());
  if (state == FreeLine::State::Free)
  {
    // The tip has moved along the retreat and has passed the points of the retreat up to Leg.
    this->enter(this->Search.route(this->Tip, this->Leg + 1), this->Search.goalSteps());
    return;
  }
  ++this->Jumps;
  this->enterAtTop();
}

void GuidedHand::enter(const RouteSearch::Route& route, std::size_t goalSteps) noexcept
{
  this->Path = route;
  this->GoalSteps = goalSteps;
  this->Leg = 0;
  this->Now = Phase::Moving;
}

/// Moves the tip along the path. In the column of a pressing goal, the tip does not move if the
/// contact would become deeper than both the present depth and the depth of the goal. This happens
/// if the contact is with another face.
void GuidedHand::moveInContact(double share, double most) noexcept
{
  const Vector3 before = this->Tip;
  this->move(share, most);
  const bool isInColumn = this->isInColumn();
  if (!isInColumn && !this->IsSearching && this->Depth == 0.0)
  {
    return;
  }
  ContactTracker tracker(*this->Tracker);
  const ContactTracker::Result contact = tracker.update(this->Tip);
  if (isInColumn && this->Goal.presses() &&
    depthOf(contact) > std::max(this->Depth, -this->Goal.height) + Rounding)
  {
    this->Tip = before;
    return;
  }
  this->acceptContact(tracker, contact);
}

void GuidedHand::move(double share, double most) noexcept
{
  if (this->Leg + 1 >= this->Path.count)
  {
    return;
  }
  const double rest =
    (this->Path.points[this->Leg + 1] - this->Tip).norm() + this->Path.lengthFrom(this->Leg + 1);
  double step = rest > AtEnd ? std::min(share * rest, most) : 2.0 * AtEnd;
  while (this->Leg + 1 < this->Path.count)
  {
    const Vector3 way = this->Path.points[this->Leg + 1] - this->Tip;
    const double length = way.norm();
    if (step < length)
    {
      this->Tip += step / length * way;
      return;
    }
    step -= length;
    this->Tip = this->Path.points[this->Leg + 1];
    if (this->Leg + 2 >= this->Path.count)
    {
      return; // Leg remains the index of the last leg
    }
    ++this->Leg;
  }
}

void GuidedHand::slide(double share, double most) noexcept
{
  constexpr double near = 1e-3; // mm; within this distance the tip moves on a straight line
  constexpr int patience = 8;   // ticks without progress
  constexpr double least = 0.1; // smallest fraction of a step that counts as progress
  constexpr int halvings = 4;   // largest number of halvings of a step over a sharp edge
  const double far = (this->Goal.point - this->Foot).norm();
  if (far < near)
  {
    this->enterColumn();
    return;
  }
  const double step = std::min(share * far, most);
  const double lift = std::clamp(share * (this->Goal.height - this->Height), -most, most);
  const bool moved = this->slideBy(step, lift, most, halvings);
  const double left = (this->Goal.point - this->Foot).norm();
  this->Stuck = moved && left < far - least * step ? 0 : this->Stuck + 1;
  if (this->Stuck > patience)
  {
    this->depart();
  }
}

/// Moves the foot by `step` (mm) towards the goal and raises the tip by `lift` (mm). Both are
/// halved, at most `halvings` times, if the tip would move farther than `farthest` (mm). Returns
/// false, without motion, if the contact would be too deep.
bool GuidedHand::slideBy(double step, double lift, double farthest, int halvings) noexcept
{
  constexpr int corrections = 4;
  const ContactBody& body = *this->Goal.body;
  const Vector3 next = this->Foot + step * (this->Goal.point - this->Foot).normalized();
  const SurfacePoint found =
    ContactTracker::follow(body.surface, body.surface.toLocal(next), this->FootTriangle);
  if (found.triangle < 0)
  {
    return false;
  }
  const Vector3 foot = found.projection.point + body.surface.centre();
  const Vector3 normal = surfaceNormal(body, found.triangle, found.projection.weights);
  // The larger of the goal's depth and the present depth, mm.
  const double most = std::max(this->Depth, -this->Goal.height);
  double height = this->Height + lift;
  for (int i = 0; i < corrections; ++i)
  {
    const Vector3 tip = foot + height * normal;
    ContactTracker tracker(*this->Tracker);
    const ContactTracker::Result contact = tracker.update(tip);
    const double excess = depthOf(contact) - most;
    if (excess <= Rounding)
    {
      if ((tip - this->Tip).norm() > farthest)
      {
        return halvings > 0 && this->slideBy(0.5 * step, 0.5 * lift, farthest, halvings - 1);
      }
      this->Foot = foot;
      this->FootNormal = normal;
      this->FootTriangle = found.triangle;
      this->acceptContact(tracker, contact);
      this->Height = height;
      this->Tip = tip;
      return true;
    }
    height += excess;
  }
  return false;
}
} // namespace palpate
