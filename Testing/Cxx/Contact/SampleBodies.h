// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_SampleBodies_h
#define palpate_testing_SampleBodies_h

#include "Contact/BodyMesh.h"
#include "Contact/PackedMesh.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

/// Triangulated bodies for the tests, with outward winding. Lengths in mm.
namespace palpate::testing
{
struct Surface
{
  std::vector<Vector3> points;
  std::vector<std::array<std::int32_t, 3>> triangles;

  BodyMesh mesh() const;
  PackedMesh packed() const;
  /// The surface with the rounded coordinates that PackedMesh stores. An exact reference must use
  /// these coordinates.
  Surface rounded() const;
  Vector3 corner(std::int32_t triangle, std::size_t k) const
  {
    return this
      ->points[static_cast<std::size_t>(this->triangles[static_cast<std::size_t>(triangle)][k])];
  }
};

/// Splits each triangle into four at the middles of its edges, and repeats this `times` times.
Surface subdivided(Surface body, int times);

/// A convex sphere of 20·4^times triangles around the origin. Its points are at the distance
/// `radius`.
Surface icosphere(double radius, int times);

/// A torus around the z axis, which is not convex.
Surface torus(double majorRadius, double minorRadius, int around, int across);

/// A prism over a polygon (x, y counter-clockwise) from z = 0 to `height`. `caps` are triangles of
/// the polygon's corners, counter-clockwise.
Surface prism(const std::vector<Eigen::Vector2d>& polygon,
  const std::vector<std::array<std::int32_t, 3>>& caps, double height);

/// The block [0,x]×[0,y]×[0,z].
Surface block(double x, double y, double z);

/// A body with the cross-section of an L: [0,20]×[0,20] without (8,20]×(8,20], 10 mm high. It has
/// one concave edge, at x = y = 8.
Surface angleBlock();

/// A block [-20,20]×[0,10], 40 mm long in z, with a V groove from (-5,10) down to (0,5). The walls
/// of the groove slope by 45°, so that they form a right angle open towards +y.
Surface grooveBlock();

/// The body with separate corners for each triangle, as in an STL file.
Surface triangleSoup(const Surface& body);

/// Two bodies without common points, the second one moved by `by`.
Surface together(Surface one, const Surface& other, const Vector3& by);

/// An open plate [0,size]² at z = 0 with the normal +z.
Surface openPlate(double size, int cells);
} // namespace palpate::testing

#endif
