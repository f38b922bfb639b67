// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/SurfacePatch.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace palpate
{
namespace
{
constexpr double CosineOfPatch = 0.5; // cosine of 60°

double arcLength(const Vector3& chord, const Vector3& contactNormal, const Vector3& pointNormal)
{
  const double length = chord.norm();
  const Vector3 side = chord - chord.dot(contactNormal) * contactNormal;
  const double sideLength = side.norm();
  if (!(sideLength > 0.0))
  {
    return length;
  }
  const double turned =
    std::abs(std::atan2(pointNormal.dot(side) / sideLength, pointNormal.dot(contactNormal)));
  const double half = 0.5 * turned;
  return half > 1e-4 ? length * half / std::sin(half) : length;
}

Vector3 tangentAway(const Vector3& chord, const Vector3& pointNormal)
{
  const Vector3 tangent = chord - chord.dot(pointNormal) * pointNormal;
  const double length = tangent.norm();
  return length > 0.0 ? Vector3(tangent / length) : Vector3(Vector3::Zero());
}
} // namespace

SurfacePatch::SurfacePatch(
  const BodyMesh& mesh, const Vector3& contact, const Vector3& normal, double reach)
  : Mesh(mesh)
  , Contact(contact)
  , Normal(normal)
  , Reach(reach)
  , Seen(mesh.pointCount(), false)
{
}

Vector3 SurfacePatch::normalAt(std::int32_t point) const
{
  const auto given = this->Given.empty() ? this->Given.end() : this->Given.find(point);
  return given == this->Given.end() ? this->Mesh.pointNormal(point) : given->second;
}

void SurfacePatch::enter(std::int32_t point)
{
  if (!this->has(point))
  {
    this->Seen[static_cast<std::size_t>(point)] = true;
    this->Front.push_back(point);
  }
}

void SurfacePatch::visit(const PatchVisitor& visitor)
{
  while (!this->Front.empty())
  {
    const std::int32_t point = this->Front.back();
    this->Front.pop_back();
    const Vector3 chord = this->Mesh.point(point) - this->Contact;
    const Vector3 pointNormal = this->normalAt(point);
    const double distance = arcLength(chord, this->Normal, pointNormal);
    visitor(point, distance, tangentAway(chord, pointNormal), pointNormal);
    if (this->Reach > 0.0 && distance > this->Reach)
    {
      continue; // the point is outside the patch
    }
    const auto around = this->Mesh.trianglesAround(point);
    for (const std::int32_t* next = around[0]; next != around[1]; ++next)
    {
      for (const std::int32_t corner : this->Mesh.corners(*next))
      {
        if (this->normalAt(corner).dot(this->Normal) >= CosineOfPatch)
        {
          this->enter(corner);
        }
      }
    }
  }
}

void visitSurfacePatch(const BodyMesh& mesh, std::int32_t triangle, const Vector3& contact,
  const Vector3& normal, double reach, const PatchVisitor& visitor)
{
  SurfacePatch patch(mesh, contact, normal, reach);
  for (const std::int32_t corner : mesh.corners(triangle))
  {
    patch.enter(corner);
  }
  patch.visit(visitor);
}
} // namespace palpate
