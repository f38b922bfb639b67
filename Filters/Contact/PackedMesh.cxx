// SPDX-License-Identifier: BSD-3-Clause
#include "PackedMesh.h"

#include "PackedMeshBuilder.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace palpate
{
PackedMesh::PackedMesh(const double* points, std::size_t pointCount, const std::int32_t* triangles,
  std::size_t triangleCount, const BuildProgress& progress)
{
  Builder(*this, progress).build(points, pointCount, triangles, triangleCount);
}

std::size_t PackedMesh::memory() const noexcept
{
  return this->Records.size() * sizeof(Record) + this->Vertices.size() * sizeof(Vertex) +
    (this->Ring.size() + this->InputTriangles.size() + this->InputPoints.size()) *
    sizeof(std::int32_t);
}

Vector3 PackedMesh::areaNormal(std::int32_t triangle) const noexcept
{
  const Vector3 a = this->corner(triangle, 0);
  return (this->corner(triangle, 1) - a).cross(this->corner(triangle, 2) - a);
}

Vector3 PackedMesh::faceNormal(std::int32_t triangle) const noexcept
{
  const Vector3 normal = this->areaNormal(triangle);
  return normal / normal.norm();
}

bool PackedMesh::isCertainlyNearest(
  const Vector3& tip, std::int32_t triangle, const TriangleProjection& projection) const noexcept
{
  const double bend = this->record(triangle).bend;
  const Vector3 a = this->corner(triangle, 0);
  const Vector3 ab = this->corner(triangle, 1) - a;
  const Vector3 ac = this->corner(triangle, 2) - a;
  const Vector3 normal = ab.cross(ac); // twice the area long
  if (!(normal.dot(tip - a) < 0.0) || !std::isfinite(bend))
  {
    return false;
  }
  // The foot is weight_k · |normal| / |edge opposite of k| from that edge.
  const double squaredArea = normal.squaredNorm();
  const double squaredNeed = 0.25 * bend * bend * projection.squaredDistance;
  const auto isFar = [&](double weight, double squaredEdge)
  { return weight * weight * squaredArea >= squaredNeed * squaredEdge; };
  return isFar(projection.weights[0], (ac - ab).squaredNorm()) &&
    isFar(projection.weights[1], ac.squaredNorm()) &&
    isFar(projection.weights[2], ab.squaredNorm());
}

bool PackedMesh::isPlaneBeyond(
  const Vector3& tip, std::int32_t triangle, double squaredDistance) const noexcept
{
  const Vector3 normal = this->areaNormal(triangle);
  const double height = normal.dot(tip - this->corner(triangle, 0));
  // 1e-12: a triangle is passed over only if it is farther by more than rounding.
  return height * height > (1.0 + 1e-12) * squaredDistance * normal.squaredNorm();
}

SurfacePoint PackedMesh::orient(
  const Vector3& tip, std::int32_t triangle, const TriangleProjection& projection) const noexcept
{
  SurfacePoint found;
  found.triangle = triangle;
  found.projection = projection;
  const auto feature = static_cast<std::size_t>(projection.feature);
  Vector3 normal; // of any length
  if (projection.feature == TriangleFeature::Face)
  {
    normal = this->areaNormal(triangle);
  }
  else if (feature < 3)
  {
    const std::int32_t corner = this->corners(triangle)[feature];
    normal = this->pointNormal(corner);
    found.onBorder = (this->Vertices[static_cast<std::size_t>(corner)].ring & 1U) != 0;
  }
  else
  {
    normal = this->faceNormal(triangle);
    const std::int32_t across = this->record(triangle).neighbours[feature - 3];
    found.onBorder = across == Border;
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
