// SPDX-License-Identifier: BSD-3-Clause
#include "SurfacePatch.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace palpate
{
namespace
{
constexpr double CosineOfPatch = 0.5; // 60°

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

void visitSurfacePatch(const BodyMesh& mesh, std::int32_t triangle, const Vector3& contact,
  const Vector3& normal, double reach, const PatchVisitor& visit)
{
  std::vector<bool> seen(mesh.pointCount(), false);
  std::vector<std::int32_t> front;
  const auto enter = [&](std::int32_t point)
  {
    if (!seen[static_cast<std::size_t>(point)])
    {
      seen[static_cast<std::size_t>(point)] = true;
      front.push_back(point);
    }
  };
  for (const std::int32_t corner : mesh.corners(triangle))
  {
    enter(corner);
  }
  while (!front.empty())
  {
    const std::int32_t point = front.back();
    front.pop_back();
    const Vector3 chord = mesh.point(point) - contact;
    const Vector3 pointNormal = mesh.pointNormal(point);
    const double distance = arcLength(chord, normal, pointNormal);
    visit(point, distance, tangentAway(chord, pointNormal));
    if (reach > 0.0 && distance > reach)
    {
      continue; // the field ends with this point
    }
    const auto around = mesh.trianglesAround(point);
    for (const std::int32_t* next = around[0]; next != around[1]; ++next)
    {
      for (const std::int32_t corner : mesh.corners(*next))
      {
        if (mesh.pointNormal(corner).dot(normal) >= CosineOfPatch)
        {
          enter(corner);
        }
      }
    }
  }
}
} // namespace palpate
