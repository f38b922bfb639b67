// SPDX-License-Identifier: BSD-3-Clause
// The part of GuidedHand that leaves the present place when a new goal arrives.
#include "Haptics/Guidance/GuidedHand.h"

#include <algorithm>

namespace palpate
{
std::size_t GuidedHand::pointsToLeave() const noexcept
{
  const std::size_t joint = this->Path.count - 1 - this->GoalSteps;
  return joint > this->Leg ? joint - this->Leg + 1 + this->Goal.steps : 1 + this->Goal.steps;
}

/// Makes the retreat from the present position, and begins to search for a path to the newest goal.
void GuidedHand::depart() noexcept
{
  this->Retreat.count = 0;
  double margin = this->Wanted.margin;
  if (this->Now == Phase::Lost || this->isBehind())
  {
    this->leaveUnknown();
  }
  else
  {
    margin = std::min(margin, this->Goal.margin);
    if (this->Now == Phase::Sliding)
    {
      this->leaveSurface();
    }
    else if (!this->isInColumn())
    {
      this->leavePath();
    }
    else if (this->canRise())
    {
      this->leaveColumn();
    }
    else
    {
      this->Foot = this->Goal.point;
      this->FootNormal = this->Goal.normal;
      this->leaveSurface();
    }
  }
  this->Search.begin(this->Retreat, this->Known, this->First, margin, this->Wanted);
  this->IsSearching = true;
  // During the search the hand moves to the first point of the retreat from which a line may begin.
  this->Path.count = 0;
  for (std::size_t i = 0; i <= this->First && i < this->Known; ++i)
  {
    this->Path.add(this->Retreat.points[i]);
  }
  this->Leg = 0;
  this->Now = Phase::Moving;
}

/// Whether a pressing tip has passed through a thin body and is outside, beyond the opposite face.
bool GuidedHand::isBehind() const noexcept
{
  const bool presses = this->Now == Phase::Sliding
    ? this->Height < 0.0
    : this->isInColumn() && this->heightInColumn() < 0.0;
  return presses && this->Depth == 0.0;
}

/// Whether the contact in the column becomes less deep when the tip rises. This is not so for some
/// contacts with another face.
bool GuidedHand::canRise() const noexcept
{
  // Cosine of the angle between the normal and the direction to the contact point.
  constexpr double least = 0.5;
  if (this->Depth == 0.0)
  {
    return true;
  }
  return (this->ContactPoint - this->Tip).dot(this->Goal.normal) > least * this->Depth;
}

void GuidedHand::leaveColumn() noexcept
{
  this->Retreat.add(this->Tip);
  for (std::size_t j = 0; j < this->Goal.steps; ++j)
  {
    this->Retreat.add(this->Goal.way[j]);
  }
  this->Known = this->Retreat.count;
  this->First = 1;
}

void GuidedHand::leavePath() noexcept
{
  // The path ends with the points GoalSteps - 1 to 0 of Goal.way and the position of the tip at the
  // goal.
  this->Retreat.add(this->Tip);
  const std::size_t joint = this->Path.count - 1 - this->GoalSteps;
  for (std::size_t i = this->Leg + 1; i < joint; ++i)
  {
    this->Retreat.add(this->Path.points[i]);
  }
  const std::size_t passed = this->Leg >= joint ? this->Leg - joint : 0;
  for (std::size_t j = this->GoalSteps - 1 - passed; j < this->Goal.steps; ++j)
  {
    this->Retreat.add(this->Goal.way[j]);
  }
  this->Known = this->Retreat.count;
  this->First = 0;
}

void GuidedHand::leaveSurface() noexcept
{
  this->Retreat.add(this->Tip);
  if (this->Depth > 0.0)
  {
    // The retreat begins with a straight line to the contact point, so that the contact becomes
    // less deep in each tick.
    this->Retreat.add(this->ContactPoint);
    this->addTop(this->ContactPoint, this->ContactNormal);
  }
  else
  {
    this->addTop(this->Foot, this->FootNormal);
  }
  for (std::size_t j = 0; j < this->Goal.steps; ++j)
  {
    this->Retreat.add(this->Goal.way[j]);
  }
}

void GuidedHand::leaveUnknown() noexcept
{
  const ContactBody& body = *this->Wanted.body;
  const double clearance = clearanceAt(body, this->Tip);
  const SurfacePoint nearest = body.tree.closest(this->Tip);
  this->Retreat.add(this->Tip);
  this->Known = 1;
  this->First = 0;
  const Vector3& foot = nearest.projection.point;
  if (nearest.triangle >= 0 && clearance < 0.0)
  {
    this->Retreat.add(foot);
    this->addTop(foot, surfaceNormal(body, nearest.triangle, nearest.projection.weights));
  }
  else if (nearest.triangle >= 0 && clearance < this->Wanted.margin)
  {
    this->addTop(foot, (this->Tip - foot).normalized());
  }
}

/// Adds the top of the column over a foot to the retreat. The last point of the retreat must be in
/// this column.
void GuidedHand::addTop(const Vector3& foot, const Vector3& normal) noexcept
{
  const double most = std::max(this->Wanted.hover, this->Goal.number > 0 ? this->Goal.hover : 0.0);
  const double height = freeHeight(*this->Wanted.body, foot, normal, most);
  const double present = (this->Retreat.last() - foot).dot(normal);
  this->Retreat.add(foot + std::max(height, present) * normal);
  this->Known = this->Retreat.count;
  this->First = this->Known - 1;
}
} // namespace palpate
