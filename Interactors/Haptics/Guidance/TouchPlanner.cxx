// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Guidance/TouchPlanner.h"

#include "Haptics/Guidance/FreeSpace.h"
#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
/// mm. A point farther from the surface is moved onto the surface. A smaller distance is only the
/// rounding of a picked point.
constexpr double OffSurface = 0.05;

/// Largest distance of a corner from the centre of the body's box, mm.
double largestRadius(const PackedMesh& mesh)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < mesh.triangleCount(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      largest = std::max(largest, mesh.corner(static_cast<std::int32_t>(i), k).squaredNorm());
    }
  }
  return std::sqrt(largest);
}

bool haveSameTriangles(const PackedMesh& mesh, const PackedMesh& other)
{
  if (mesh.triangleCount() != other.triangleCount() || mesh.centre() != other.centre())
  {
    return false;
  }
  for (std::size_t i = 0; i < mesh.triangleCount(); ++i)
  {
    const auto triangle = static_cast<std::int32_t>(i);
    if (!std::equal(
          mesh.coordinates(triangle), mesh.coordinates(triangle) + 9, other.coordinates(triangle)))
    {
      return false;
    }
  }
  return true;
}
} // namespace

void TouchPlanner::setBody(std::shared_ptr<const ContactBody> body)
{
  if (this->hasBody() && this->Bodies.back().kernel == body)
  {
    return;
  }
  if (!this->hasBody() || !haveSameTriangles(this->Bodies.back().kernel->surface, body->surface))
  {
    ++this->Surface;
    // A polygon on this sphere whose chords span 22.5° is at least 5 % outside the body.
    this->Radius = 1.08 * largestRadius(body->surface) + 2.0 * Approach;
  }
  this->Bodies.push_back({ std::move(body), ++this->LastBody });
}

void TouchPlanner::release(std::uint64_t oldest)
{
  while (this->Bodies.size() > 1 && this->Bodies.front().number < oldest)
  {
    this->Bodies.pop_front();
  }
}

TouchGoal TouchPlanner::plan(const Vector3& point, const Vector3& normal, double height)
{
  constexpr double marginShare = 0.25; // fraction of the height of the column
  const Body& newest = this->Bodies.back();
  const ContactBody& body = *newest.kernel;
  // The lowest point of a tilted tool is below the tip.
  const double drop = body.tilt ? body.tilt->largestDrop() : 0.0;
  const double most = (height > 0.0 ? height : Approach) + drop;
  TouchGoal goal = this->Last;
  const bool isSame = goal.number > 0 && goal.surface == this->Surface &&
    this->LastPoint == point && this->LastNormal == normal && most == this->LastMost;
  goal.number = ++this->LastNumber;
  goal.bodyNumber = newest.number;
  goal.body = &body;
  if (!isSame)
  {
    goal.surface = this->Surface;
    goal.point = point;
    goal.normal = normal;
    const SurfacePoint closest = body.tree.closest(point);
    goal.triangle = closest.triangle;
    if (closest.triangle >= 0 && (closest.projection.point - point).norm() > OffSurface)
    {
      goal.point = closest.projection.point; // for example after a change of the body
      goal.normal = surfaceNormal(body, closest.triangle, closest.projection.weights);
    }
    goal.hover = freeHeight(body, goal.point, goal.normal, most);
    goal.margin = marginShare * std::min(goal.hover, Approach) + (goal.hover > drop ? drop : 0.0);
    goal.centre = body.surface.centre();
    const Vector3 top = goal.point + goal.hover * goal.normal;
    goal.radius = std::max(this->Radius, (top - goal.centre).norm() + Approach);
    this->findWay(goal);
  }
  goal.height = height > 0.0 ? goal.hover : height;
  this->Last = goal;
  this->LastMost = most;
  this->LastPoint = point;
  this->LastNormal = normal;
  return goal;
}

void TouchPlanner::findWay(TouchGoal& goal) const
{
  goal.way[0] = goal.point + goal.hover * goal.normal;
  goal.steps = 1;
  goal.leadsOut = goal.margin > 0.0 &&
    (this->leaveNear(goal.normal, goal) ||
      (this->climb(goal) && this->leaveNear(goal.normal, goal)));
}

bool TouchPlanner::leaveNear(const Vector3& normal, TouchGoal& goal) const
{
  for (int i = 0; i < SpiralDirections; ++i)
  {
    if (this->leaveAlong(spiralDirection(normal, i), goal))
    {
      return true;
    }
  }
  return false;
}

bool TouchPlanner::leaveAlong(const Vector3& direction, TouchGoal& goal) const
{
  const Vector3 from = goal.way[goal.steps - 1];
  const double length = lengthToSphere(from - goal.centre, direction, goal.radius);
  if (!(length > 0.0) || !isFree(*goal.body, from, from + length * direction, goal.margin))
  {
    return false;
  }
  // The distances of the points grow geometrically. A hand may leave the path at each of its
  // points.
  const std::size_t more = TouchGoal::MostSteps - goal.steps;
  const double first = std::min(Approach, length);
  for (std::size_t i = 1; i <= more; ++i)
  {
    const double share =
      more > 1 ? static_cast<double>(i - 1) / static_cast<double>(more - 1) : 1.0;
    goal.way[goal.steps++] = from + first * std::pow(length / first, share) * direction;
  }
  return true;
}

/// Moves a point away from the surface to the middle of a hollow, and adds this point to the path.
bool TouchPlanner::climb(TouchGoal& goal) const
{
  constexpr int mostMoves = 64;
  constexpr double growth = 1.001; // least ratio by which the clearance must grow in a move
  Vector3 at = goal.way[0];
  double clearance = clearanceAt(*goal.body, at);
  for (int i = 0; i < mostMoves; ++i)
  {
    const Vector3 away = at - goal.body->tree.closest(at).projection.point;
    const Vector3 next = at + 0.25 * away;
    const double there = clearanceAt(*goal.body, next);
    if (!(there > growth * clearance))
    {
      break;
    }
    at = next;
    clearance = there;
  }
  if (at == goal.way[0] || !isFree(*goal.body, goal.way[0], at, goal.margin))
  {
    return false;
  }
  goal.way[goal.steps++] = at;
  return true;
}
} // namespace palpate
