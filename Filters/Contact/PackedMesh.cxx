// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/PackedMesh.h"

#include "Contact/PackedMeshBuilder.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
PackedMesh::PackedMesh(const double* points, std::size_t pointCount, const std::int32_t* triangles,
  std::size_t triangleCount, const BuildProgress& progress, const CreaseRule& creases)
{
  Builder(*this, progress, creases).build(points, pointCount, triangles, triangleCount);
}

PackedMesh::PackedMesh(const double* points, std::size_t pointCount, const std::int32_t* triangles,
  std::size_t triangleCount)
  : PackedMesh(points, pointCount, triangles, triangleCount, {}, {})
{
}

std::size_t PackedMesh::memory() const noexcept
{
  return this->Records.size() * sizeof(Record) + this->Vertices.size() * sizeof(Vertex) +
    (this->Ring.size() + this->InputTriangles.size() + this->InputPoints.size()) *
    sizeof(std::int32_t) +
    this->Creases.size() * sizeof(CreaseSide) + this->CornerNormals.size() * sizeof(CornerNormal) +
    this->Folded.size();
}

Vector3 PackedMesh::faceNormal(std::int32_t triangle) const noexcept
{
  const Vector3 normal = this->areaNormal(triangle);
  return normal / normal.norm();
}

bool PackedMesh::isPlaneBeyond(
  const Vector3& tip, std::int32_t triangle, double squaredDistance) const noexcept
{
  const Vector3 normal = this->areaNormal(triangle);
  const double height = normal.dot(tip - this->corner(triangle, 0));
  // The factor with 1e-12 ensures that a triangle is skipped only if it is farther away by more
  // than the rounding error.
  return height * height > (1.0 + 1e-12) * squaredDistance * normal.squaredNorm();
}

bool PackedMesh::isUnderCorner(const Vector3& tip, const SurfacePoint& closest) const noexcept
{
  const auto feature = static_cast<std::size_t>(closest.projection.feature);
  if (feature >= 3)
  {
    return false;
  }
  const std::int32_t corner = this->corners(closest.triangle)[feature];
  const auto found = std::lower_bound(this->CornerNormals.begin(), this->CornerNormals.end(),
    corner, [](const CornerNormal& one, std::int32_t point) { return one.point < point; });
  return found != this->CornerNormals.end() && found->point == corner &&
    found->normal.dot(tip - closest.projection.point) < 0.0;
}

SurfacePoint PackedMesh::orient(
  const Vector3& tip, std::int32_t triangle, const TriangleProjection& projection) const noexcept
{
  SurfacePoint found;
  found.triangle = triangle;
  found.projection = projection;
  const auto feature = static_cast<std::size_t>(projection.feature);
  Vector3 normal; // normal of the closest feature, not normalised
  if (projection.feature == TriangleFeature::Face)
  {
    normal = this->areaNormal(triangle);
  }
  else if (feature < 3)
  {
    const std::int32_t corner = this->corners(triangle)[feature];
    normal = this->pointNormal(corner);
    found.onBorder = (this->Vertices[static_cast<std::size_t>(corner)].ring & BorderFlag) != 0;
    found.onCrease = this->isOnCrease(corner);
  }
  else
  {
    normal = this->faceNormal(triangle);
    const std::int32_t across = this->record(triangle).neighbours[feature - 3];
    found.onBorder = across == Border;
    found.onCrease = across == Crease;
    if (across >= 0)
    {
      normal += this->faceNormal(across);
    }
  }
  const double distance = std::sqrt(projection.squaredDistance);
  found.signedDistance = (tip - projection.point).dot(normal) < 0.0 ? -distance : distance;
  return found;
}
} // namespace palpate
