// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/PackedMeshBuilder.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace palpate
{
namespace
{
/// The plane of a triangle. It computes the slope of other triangles: their depth below the plane,
/// divided by their distance from this triangle within the plane.
class TrianglePlane
{
public:
  explicit TrianglePlane(const std::array<Vector3, 3>& corners);

  /// Returns the smallest slope b such that every point of another triangle at corner k is below
  /// the plane by at most b times its distance from this triangle; infinite if there is no such
  /// slope. The search tests a few directions away from this triangle: along such a direction, the
  /// distance from the corner is at most the distance from the triangle. The search stops at a
  /// slope <= `enough`.
  double slopeTo(const std::array<Vector3, 3>& other, std::size_t k, double enough) const;

  /// Returns the smallest altitude of the triangle, mm.
  double smallestAltitude() const { return this->Altitude; }

private:
  double slopeAlong(const Vector3& direction, const std::array<Vector3, 3>& offset,
    const std::array<double, 3>& depth) const;

  std::array<Vector3, 3> Corner;
  Vector3 Normal;
  /// Unit vector in the plane, away from the triangle across edge i.
  std::array<Vector3, 3> FromEdge;
  /// Unit vector between the FromEdge of the two edges at the corner.
  std::array<Vector3, 3> FromCorner;
  double Altitude;
  double Rounding; ///< smaller lengths count as 0
};

TrianglePlane::TrianglePlane(const std::array<Vector3, 3>& corners)
  : Corner(corners)
  , Normal((corners[1] - corners[0]).cross(corners[2] - corners[0]))
{
  const double twiceArea = this->Normal.norm();
  this->Normal /= twiceArea;
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vector3 edge = corners[(k + 1) % 3] - corners[k];
    const double length = edge.norm();
    this->FromEdge[k] = edge.cross(this->Normal) / length;
    longest = std::max(longest, length);
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    // At the tip of a needle the direction is undefined (NaN), which results in no slope.
    this->FromCorner[k] = this->FromEdge[k] + this->FromEdge[(k + 2) % 3];
    this->FromCorner[k] /= this->FromCorner[k].norm();
  }
  this->Altitude = twiceArea / longest;
  this->Rounding = 1e-13 * longest;
}

double TrianglePlane::slopeTo(
  const std::array<Vector3, 3>& other, std::size_t k, double enough) const
{
  std::array<Vector3, 3> offset;
  std::array<double, 3> depth;
  for (std::size_t i = 0; i < 3; ++i)
  {
    offset[i] = other[i] - this->Corner[k];
    depth[i] = -this->Normal.dot(offset[i]);
  }
  if (std::max({ depth[0], depth[1], depth[2] }) <= this->Rounding)
  {
    return 0.0;
  }
  double smallest = std::numeric_limits<double>::infinity();
  for (const Vector3* direction :
    { &this->FromEdge[k], &this->FromCorner[k], &this->FromEdge[(k + 2) % 3] })
  {
    smallest = std::min(smallest, this->slopeAlong(*direction, offset, depth));
    if (smallest <= enough)
    {
      break;
    }
  }
  return smallest;
}

double TrianglePlane::slopeAlong(const Vector3& direction, const std::array<Vector3, 3>& offset,
  const std::array<double, 3>& depth) const
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> away;
  double slope = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    away[i] = direction.dot(offset[i]);
    if (depth[i] > this->Rounding)
    {
      slope = away[i] > this->Rounding ? std::max(slope, depth[i] / away[i]) : infinity;
    }
  }
  for (std::size_t i = 0; i < 3 && slope < infinity; ++i)
  {
    slope = slope * away[i] >= depth[i] - this->Rounding ? slope : infinity;
  }
  return slope;
}
} // namespace

float steepnessOf(const PackedMesh& mesh, std::int32_t triangle)
{
  const auto cornersOf = [&mesh](std::int32_t t) -> std::array<Vector3, 3> {
    return { mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2) };
  };
  const TrianglePlane plane(cornersOf(triangle));
  double slope = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const auto corner = static_cast<std::size_t>(k);
    mesh.visitAround(mesh.corners(triangle)[corner],
      [&](std::int32_t other)
      {
        // The neighbour across the edge that ends at this corner was already visited at the start
        // of that edge.
        if (other != triangle && other != mesh.neighbour(triangle, (k + 2) % 3))
        {
          slope = std::max(slope, plane.slopeTo(cornersOf(other), corner, slope));
        }
      });
  }
  // Rounded up to the next float.
  const double rounded = 0.5 * slope / plane.smallestAltitude() * (1.0 + 1e-6);
  return static_cast<float>(rounded);
}
} // namespace palpate
