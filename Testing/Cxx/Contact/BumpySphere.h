// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_BumpySphere_h
#define palpate_testing_BumpySphere_h

#include "SampleBodies.h"

#include <cstddef>
#include <vector>

/**
 * A body with any number of triangles, for sliding tips: a sphere with a mean radius of 100 mm and
 * bumps up to 1 mm high, about 20 mm apart,
 *   r(u) = 100 + sin 15x sin 15y cos 15z   (mm; u = (x, y, z) is the unit direction).
 * The body is not convex (curvatures from -1/73 mm), but its curvature is small: the smallest
 * convex radius is 30.2 mm, far above any depth of a tip. Therefore a tip that is up to 5 mm below
 * a surface point along its normal has this point as its closest point (except for the facets).
 */
namespace palpate::testing
{
/// Surface point and outward unit normal in the direction of a unit vector from the centre.
Vector3 bumpyPoint(const Vector3& direction);
Vector3 bumpyNormal(const Vector3& direction);

/// An octahedron whose faces are divided into cuts² triangles each and projected onto the bumpy
/// sphere. It has 8 cuts² triangles and 4 cuts² + 2 points, row by row as from a mesh generator,
/// and is closed with outward winding. 4 million triangles take 0.15 s.
Surface bumpySphere(int cuts);

/// The number of cuts for which the bumpy sphere has about this many triangles; at least 1.
int bumpyCuts(double triangles);

/// The outward unit normals of the smooth body at the points of a bumpy sphere.
std::vector<Vector3> bumpyNormals(const Surface& body);

/// Extreme principal curvatures of the smooth body, 1/mm, positive if convex. Evaluated in
/// `samples` evenly distributed directions.
struct CurvatureRange
{
  double least;
  double greatest;
};
CurvatureRange bumpyCurvatures(int samples);

/// Direction of a path that winds around the sphere. Each turn is a new great circle, tilted by
/// 0.09 rad. The direction is `along` mm from the start and `across` mm to the side (arc length on
/// the mean sphere). Over 21 m the path does not return to a place, except at the two poles of the
/// tilt.
Vector3 windingDirection(double along, double across = 0.0);

/// A tip `depth` mm below the smooth body, `along` mm from the start of the winding path.
Vector3 windingTip(double depth, double along, double across = 0.0);

/// `count` tips at a depth of `depth` mm, `step` mm apart along the winding path.
std::vector<Vector3> windingTips(std::size_t count, double depth, double step);

/// The same surface with its points and triangles in random order. Each triangle starts at a random
/// corner. `pointOf` and `triangleOf`, if given, receive the original numbers.
Surface shuffled(const Surface& body, unsigned seed, std::vector<std::int32_t>* pointOf = nullptr,
  std::vector<std::int32_t>* triangleOf = nullptr);
} // namespace palpate::testing

#endif
