// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Guidance/FreeSpace.h"

#include "Mechanics/Numerics/Constants.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace palpate
{
double clearanceAt(const ContactBody& body, const Vector3& point) noexcept
{
  const PackedMesh& mesh = body.surface;
  const Vector3 local = mesh.toLocal(point);
  const SurfacePoint nearest = local.allFinite() ? body.tree.closestLocal(local) : SurfacePoint{};
  if (nearest.triangle < 0)
  {
    return NotANumber;
  }
  if (!nearest.onCrease)
  {
    return nearest.signedDistance;
  }
  // A point whose closest point is on a convex edge is outside (ContactTracker::begin).
  const double distance = std::abs(nearest.signedDistance);
  return mesh.isUnderCorner(local, nearest) ? -distance : distance;
}

Vector3 surfaceNormal(
  const ContactBody& body, std::int32_t triangle, const Vector3& weights) noexcept
{
  const TriangleCorners& corners = body.surface.corners(triangle);
  Vector3 sum = Vector3::Zero();
  for (std::size_t k = 0; k < 3; ++k)
  {
    sum += weights[static_cast<Eigen::Index>(k)] * body.response.normal(corners[k]);
  }
  const double length = sum.norm();
  return length > 0.0 && std::isfinite(length) ? Vector3(sum / length)
                                               : body.surface.faceNormal(triangle);
}

double freeHeight(
  const ContactBody& body, const Vector3& point, const Vector3& normal, double most) noexcept
{
  constexpr double share = 0.35; // above 1/3, so that the ball at z intersects the ball at z/2
  constexpr int halves = 10;
  double height = 0.0;
  for (int i = halves; i >= 0; --i)
  {
    const double next = std::ldexp(most, -i);
    if (!(clearanceAt(body, point + next * normal) >= share * next))
    {
      break;
    }
    height = next;
  }
  return height;
}

Vector3 spiralDirection(const Vector3& axis, int i) noexcept
{
  const double turn = i * Pi * (3.0 - std::sqrt(5.0));
  const Vector3 x = axis.unitOrthogonal();
  const Vector3 y = axis.cross(x);
  const double along = 1.0 - 2.0 * i / SpiralDirections;
  const double across = std::sqrt(std::max(0.0, 1.0 - along * along));
  return along * axis + across * (std::cos(turn) * x + std::sin(turn) * y);
}

double lengthToSphere(const Vector3& from, const Vector3& along, double radius) noexcept
{
  const double half = from.dot(along);
  const double square = half * half + radius * radius - from.squaredNorm();
  return square > 0.0 ? std::max(0.0, std::sqrt(square) - half) : 0.0;
}

void FreeLine::begin(
  const ContactBody& body, const Vector3& from, const Vector3& to, double margin) noexcept
{
  this->Body = &body;
  this->From = from;
  this->Along = to - from;
  this->Length = this->Along.norm();
  this->Along /= this->Length > 0.0 ? this->Length : 1.0;
  this->Margin = margin;
  this->Done = 0.0;
  this->Used = 0;
  this->Found = State::Unknown;
}

FreeLine::State FreeLine::go(int& queries) noexcept
{
  while (this->Found == State::Unknown && queries > 0)
  {
    --queries;
    const double clearance = clearanceAt(*this->Body, this->From + this->Done * this->Along);
    if (!(clearance >= this->Margin) || ++this->Used > MostQueries)
    {
      this->Found = State::Blocked;
      break;
    }
    this->Done += clearance - 0.5 * this->Margin;
    if (this->Done >= this->Length)
    {
      this->Found = State::Free;
    }
  }
  return this->Found;
}

bool isFree(const ContactBody& body, const Vector3& from, const Vector3& to, double margin) noexcept
{
  FreeLine line;
  line.begin(body, from, to, margin);
  int queries = 1 << 20;
  return line.go(queries) == FreeLine::State::Free;
}
} // namespace palpate
