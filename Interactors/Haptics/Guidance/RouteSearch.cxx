// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Guidance/RouteSearch.h"

#include "Mechanics/Numerics/Constants.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
void RouteSearch::begin(const Retreat& retreat, std::size_t known, std::size_t first, double margin,
  const TouchGoal& goal) noexcept
{
  this->Goal = goal;
  this->Way = retreat;
  this->Known = known;
  this->First = first;
  this->Margin = margin;
  this->Tried.fill(0);
  this->Direction = 0;
  this->Arc.count = 0;
  this->Now = Stage::Choose;
  this->Found = FreeLine::State::Unknown;
  if (!(margin > 0.0))
  {
    this->end(FreeLine::State::Blocked);
  }
}

void RouteSearch::choose() noexcept
{
  double shortest = std::numeric_limits<double>::infinity();
  double there = 0.0; // length of the retreat to its point i
  for (std::size_t i = 0; i < this->Way.count; ++i)
  {
    there += i > 0 ? (this->Way.points[i] - this->Way.points[i - 1]).norm() : 0.0;
    double down = 0.0; // length of the goal's path from its step j to the goal
    for (std::size_t j = 0; i >= this->First && j < this->Goal.steps; ++j)
    {
      down += j > 0 ? (this->Goal.way[j] - this->Goal.way[j - 1]).norm() : 0.0;
      const double length = there + (this->Goal.way[j] - this->Way.points[i]).norm() + down;
      if (length < shortest && (this->Tried[i] >> j & 1U) == 0)
      {
        shortest = length;
        this->From = i;
        this->To = j;
      }
    }
  }
  if (!std::isfinite(shortest))
  {
    const bool leadsOut = this->Known == this->Way.count && this->isOutside(this->Way.last());
    leadsOut ? this->beginArc() : this->escape();
    return;
  }
  const bool isKnown = this->From < this->Known;
  const Vector3& from = this->Way.points[isKnown ? this->From : this->Known - 1];
  const Vector3& to = isKnown ? this->Goal.way[this->To] : this->Way.points[this->Known];
  this->Line.begin(*this->Goal.body, from, to, this->Margin);
  this->Now = isKnown ? Stage::Line : Stage::Extend;
}

bool RouteSearch::isOutside(const Vector3& point) const noexcept
{
  constexpr double rounding = 1e-6;
  return (point - this->Goal.centre).norm() > (1.0 - rounding) * this->Goal.radius;
}

void RouteSearch::escape() noexcept
{
  if (this->Direction == SpiralDirections || this->Known == MostRetreat)
  {
    this->end(FreeLine::State::Blocked);
    return;
  }
  this->Way.count = this->Known;
  const Vector3& from = this->Way.last();
  const Vector3 offset = from - this->Goal.centre;
  const Vector3 axis = this->Known > 1 ? Vector3(from - this->Way.points[this->Known - 2]) : offset;
  const Vector3 direction = spiralDirection(
    axis.norm() > 0.0 ? Vector3(axis.normalized()) : Vector3(Vector3::UnitZ()), this->Direction++);
  const double length = lengthToSphere(offset, direction, this->Goal.radius);
  this->Line.begin(*this->Goal.body, from, from + length * direction, this->Margin);
  this->Now = Stage::Escape;
}

void RouteSearch::beginArc() noexcept
{
  const Vector3 from = this->Way.last() - this->Goal.centre;
  const Vector3 to = this->Goal.way[this->Goal.steps - 1] - this->Goal.centre;
  if (!this->Goal.leadsOut || !from.allFinite() || !to.allFinite())
  {
    this->end(FreeLine::State::Blocked);
    return;
  }
  // The arc follows the great circle, in legs of at most 22.5°. Between opposite points it passes
  // through an arbitrary pole.
  const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
  const Vector3 across = from.cross(to).norm() > 1e-9 * from.squaredNorm()
    ? Vector3(from.cross(to).normalized())
    : from.normalized().unitOrthogonal();
  const auto legs =
    static_cast<std::size_t>(std::clamp(std::ceil(angle / (Pi / 8.0)), 1.0, double{ MostArc }));
  this->From = this->Way.count - 1;
  this->To = this->Goal.steps - 1;
  for (std::size_t i = 1; i < legs; ++i)
  {
    const double turn = angle * static_cast<double>(i) / static_cast<double>(legs);
    const double scale = this->Goal.radius / from.norm();
    this->Arc.add(this->Goal.centre + scale * (Eigen::AngleAxisd(turn, across) * from));
  }
  this->ArcLeg = 0;
  const Vector3& first = this->Arc.count > 0 ? this->Arc.points[0] : this->Goal.way[this->To];
  this->Line.begin(*this->Goal.body, this->Way.last(), first, this->Margin);
  this->Now = Stage::Arc;
}

FreeLine::State RouteSearch::go(int queries) noexcept
{
  while (this->Now != Stage::Done && queries > 0)
  {
    if (this->Now == Stage::Choose)
    {
      this->choose();
      --queries; // counted although it is not a query, so that each tick ends
      continue;
    }
    const FreeLine::State state = this->Line.go(queries);
    if (state == FreeLine::State::Unknown)
    {
      break;
    }
    this->endLeg(state == FreeLine::State::Free);
  }
  return this->Found;
}

void RouteSearch::endLeg(bool isFree) noexcept
{
  const Stage ended = this->Now;
  this->Now = Stage::Choose;
  switch (ended)
  {
    case Stage::Extend:
      if (isFree)
      {
        ++this->Known;
        break;
      }
      std::copy(this->Way.points.begin() + static_cast<std::ptrdiff_t>(this->Known) + 1,
        this->Way.points.begin() + static_cast<std::ptrdiff_t>(this->Way.count),
        this->Way.points.begin() + static_cast<std::ptrdiff_t>(this->Known));
      --this->Way.count;
      break;
    case Stage::Line:
      this->Tried[this->From] |= 1U << this->To;
      if (isFree)
      {
        this->end(FreeLine::State::Free);
      }
      break;
    case Stage::Escape:
      if (isFree)
      {
        this->addEscape();
      }
      break;
    default: // a leg of the arc
      this->nextArcLeg(isFree);
  }
}

/// Adds points to the retreat along the line that was found by an escape. The distances of the
/// points grow geometrically.
void RouteSearch::addEscape() noexcept
{
  constexpr int steps = 4;
  const Vector3 from = this->Way.last();
  const Vector3 way = this->Line.end() - from;
  const double first = std::min(1.0, this->Margin / std::max(way.norm(), this->Margin));
  for (int i = 1; i <= steps && this->Way.count + 1 < MostRetreat; ++i)
  {
    this->Way.add(from + std::pow(first, 1.0 - static_cast<double>(i) / steps) * way);
  }
  this->Way.points[this->Way.count - 1] = from + way;
  this->Known = this->Way.count;
}

void RouteSearch::nextArcLeg(bool isFree) noexcept
{
  if (!isFree || ++this->ArcLeg > this->Arc.count)
  {
    this->end(isFree ? FreeLine::State::Free : FreeLine::State::Blocked);
    return;
  }
  this->Line.begin(*this->Goal.body, this->Arc.points[this->ArcLeg - 1],
    this->ArcLeg < this->Arc.count ? this->Arc.points[this->ArcLeg] : this->Goal.way[this->To],
    this->Margin);
  this->Now = Stage::Arc;
}

RouteSearch::Route RouteSearch::route(const Vector3& tip, std::size_t next) const noexcept
{
  Route route;
  route.add(tip);
  for (std::size_t i = next; i <= this->From; ++i)
  {
    route.add(this->Way.points[i]);
  }
  for (std::size_t i = 0; i < this->Arc.count; ++i)
  {
    route.add(this->Arc.points[i]);
  }
  for (std::size_t j = this->To + 1; j-- > 0;)
  {
    route.add(this->Goal.way[j]);
  }
  route.add(this->Goal.tip());
  return route;
}
} // namespace palpate
