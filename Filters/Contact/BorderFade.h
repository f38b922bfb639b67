// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BorderFade_h
#define palpate_BorderFade_h

#include "Contact/PackedMesh.h"
#include "Contact/Pressed.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace palpate
{
/**
 * Force on a tip that has slid off an open border of the surface.
 *
 * Beyond a border there is no surface and no depth. A force that vanishes between two ticks would
 * be noticed as a knock, so the force fades with the distance of the tip from the border. Let h be
 * the depth of the tip below the surface at the border, and l its distance beyond the border,
 * measured within the surface. The force is then the fraction
 *   (1 - l/h)² (1 + 2 l/h)
 * of the force at depth h. The fraction is 1 directly under the border and 0 for l >= h, and its
 * slope is continuous at both ends. The force acts along the normal of the surface. No force pulls
 * the tip back to the border.
 *
 * The fade depends only on the position of the tip, not on its path. It is continuous if the
 * surface at the border is flat or bends only along the border. Otherwise the force jumps where two
 * triangles meet at an angle. Energy is not conserved: a tip that enters from the side reaches a
 * depth without the work of pressing.
 */
struct BorderFade
{
  double depth = 0.0;    ///< depth h, mm, >= 0
  double fraction = 0.0; ///< remaining fraction of the force at depth h, 0 to 1

  /// Evaluates the fade for a point on the border of a triangle. `weights` are the area coordinates
  /// of the point: one of them is zero on an edge, two at a corner. `offset` is the vector from the
  /// point to the tip, which is on the inner side.
  static BorderFade at(const PackedMesh& mesh, std::int32_t triangle, const Vector3& weights,
    const Vector3& offset) noexcept;
  /// Sets Pressed::reach of a tool beyond a border to the depth and the fraction of the fade. `tip`
  /// is the point that the tracker follows.
  static void reach(const PackedMesh& mesh, const Vector3& tip, Pressed& pressed) noexcept;

private:
  /// Length (>= 0) of the projection of a vector on the cone between two unit vectors.
  static double lengthBetween(
    const Vector3& vector, const Vector3& one, const Vector3& other) noexcept;
  /// Depth under a corner: the largest length of -offset within a cone between the normals of two
  /// triangles with a border edge that ends at the corner. A manifold has exactly two such
  /// triangles. If there are more, every pair of them is considered.
  static double depthAtCorner(
    const PackedMesh& mesh, std::int32_t triangle, int corner, const Vector3& offset) noexcept;
};

inline double BorderFade::lengthBetween(
  const Vector3& vector, const Vector3& one, const Vector3& other) noexcept
{
  const double a = vector.dot(one);
  const double b = vector.dot(other);
  const double cosine = one.dot(other);
  const double alpha = a - cosine * b;
  const double beta = b - cosine * a;
  const double squaredSine = 1.0 - cosine * cosine;
  // If this condition is false, the projection is on a border of the cone.
  if (alpha > 0.0 && beta > 0.0 && squaredSine > 1e-12)
  {
    return std::sqrt((alpha * a + beta * b) / squaredSine);
  }
  return std::max({ a, b, 0.0 });
}

inline double BorderFade::depthAtCorner(
  const PackedMesh& mesh, std::int32_t triangle, int corner, const Vector3& offset) noexcept
{
  const Vector3 place = mesh.corner(triangle, corner);
  Vector3 last = Vector3::Zero();
  double depth = 0.0;
  mesh.visitAround(mesh.corners(triangle)[static_cast<std::size_t>(corner)],
    [&](std::int32_t around)
    {
      for (int edge = 0; edge < 3; ++edge)
      {
        const bool endsHere =
          mesh.corner(around, edge) == place || mesh.corner(around, (edge + 1) % 3) == place;
        if (endsHere && mesh.neighbour(around, edge) == PackedMesh::Border)
        {
          const Vector3 normal = mesh.faceNormal(around);
          depth = std::max(depth, lengthBetween(-offset, normal, last));
          last = normal;
        }
      }
    });
  return depth;
}

inline BorderFade BorderFade::at(const PackedMesh& mesh, std::int32_t triangle,
  const Vector3& weights, const Vector3& offset) noexcept
{
  BorderFade fade;
  if ((weights.array() == 0.0).count() == 2)
  {
    Eigen::Index corner;
    weights.maxCoeff(&corner);
    fade.depth = depthAtCorner(mesh, triangle, static_cast<int>(corner), offset);
  }
  else
  {
    fade.depth = std::max(0.0, -mesh.faceNormal(triangle).dot(offset));
  }
  const double beyond = std::sqrt(std::max(0.0, offset.squaredNorm() - fade.depth * fade.depth));
  const double left = beyond < fade.depth ? 1.0 - beyond / fade.depth : 0.0;
  fade.fraction = left * left * (3.0 - 2.0 * left);
  return fade;
}

inline void BorderFade::reach(const PackedMesh& mesh, const Vector3& tip, Pressed& pressed) noexcept
{
  ContactPlace& place = pressed.place();
  const BorderFade fade =
    at(mesh, place.triangle, place.projection.weights, tip - place.projection.point);
  pressed.reach.depth = fade.depth - pressed.sunk;
  // Its gradient is left 0, so that no force pulls the tip back.
  pressed.reach.share.value = fade.fraction;
  place.normal = mesh.faceNormal(place.triangle);
  place.weightGradients.setZero();
}
} // namespace palpate

#endif
