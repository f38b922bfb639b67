// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Pieces/SeamNormals.h"

#include "Response/Pieces/BodySeam.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace palpate
{
namespace
{
using Sum = std::array<double, 3>;

/// Returns the sum of the normals of one piece's triangles around a point, weighted by the angles
/// of the triangles at the point.
Sum angleWeightedSum(const BodyMesh& mesh, std::int32_t point)
{
  Vector3 sum = Vector3::Zero();
  const auto around = mesh.trianglesAround(point);
  for (const std::int32_t* triangle = around[0]; triangle != around[1]; ++triangle)
  {
    const TriangleCorners& corner = mesh.corners(*triangle);
    const std::size_t k = corner[0] == point ? 0 : corner[1] == point ? 1 : 2;
    const Vector3 at = mesh.point(point);
    const Vector3 u = mesh.point(corner[(k + 1) % 3]) - at;
    const Vector3 v = mesh.point(corner[(k + 2) % 3]) - at;
    const Vector3 normal = u.cross(v);
    sum += std::atan2(normal.norm(), u.dot(v)) * normal.normalized();
  }
  return { sum.x(), sum.y(), sum.z() };
}

/// Returns six times the sum of the volumes of the tetrahedra between the triangles and `origin`.
double sixfoldVolume(const BodyMesh& mesh, const Vector3& origin)
{
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
  {
    const auto triangle = static_cast<std::int32_t>(t);
    if (mesh.isUsable(triangle))
    {
      const TriangleCorners& corner = mesh.corners(triangle);
      sum += (mesh.point(corner[0]) - origin)
               .dot((mesh.point(corner[1]) - origin).cross(mesh.point(corner[2]) - origin));
    }
  }
  return sum;
}
} // namespace

std::vector<Vector3> seamNormals(const BodyMesh& piece, const BodySeam& seam)
{
  std::vector<Sum> own;
  own.reserve(seam.places().size());
  for (const BodySeam::Place& place : seam.places())
  {
    own.push_back(angleWeightedSum(piece, place.point));
  }
  const std::vector<Sum> whole = seam.combined(own, Sum{ 0.0, 0.0, 0.0 },
    [](const Sum& a, const Sum& b) -> Sum {
      return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
    });
  std::vector<Vector3> normals;
  normals.reserve(whole.size());
  for (const Sum& sum : whole)
  {
    const Vector3 normal(sum[0], sum[1], sum[2]);
    const double length = normal.norm();
    normals.push_back(length > 0.0 ? Vector3(normal / length) : normal);
  }
  return normals;
}

SeamClosure closureOf(const BodyMesh& piece, const BodySeam& seam)
{
  const BodyMesh::Defects& found = piece.defects();
  const std::vector<double> open{ static_cast<double>(found.borderEdges),
    static_cast<double>(found.nonManifoldEdges + found.notFinite + found.badIndex) };
  // The common origin is within the body. It is a point of the lowest rank that has a usable
  // triangle.
  std::vector<Sum> origin;
  for (std::size_t t = 0; t < piece.triangleCount() && origin.empty(); ++t)
  {
    if (piece.isUsable(static_cast<std::int32_t>(t)))
    {
      const Vector3 x = piece.point(piece.corners(static_cast<std::int32_t>(t))[0]);
      origin.push_back({ x.x(), x.y(), x.z() });
    }
  }
  double borderEdges = -static_cast<double>(seam.joinedEdges());
  double defects = 0.0;
  for (const std::vector<double>& each : seam.ranks().gather(open))
  {
    borderEdges += each[0];
    defects += each[1];
  }
  std::vector<Sum> first;
  for (const std::vector<Sum>& each : seam.ranks().gather(origin))
  {
    first = first.empty() ? each : first;
  }
  SeamClosure closure;
  closure.isClosed = borderEdges == 0.0 && defects == 0.0 && !first.empty();
  const double own = closure.isClosed
    ? sixfoldVolume(piece, Vector3(first.front()[0], first.front()[1], first.front()[2]))
    : 0.0;
  for (const std::vector<double>& each : seam.ranks().gather(std::vector<double>{ own }))
  {
    closure.enclosedVolume += each.front() / 6.0;
  }
  return closure;
}
} // namespace palpate
