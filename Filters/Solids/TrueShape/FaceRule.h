// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * Quadrature over one face of an element of a field that is singular at the origin.
 *
 * A face that does not contain the origin is integrated with Gauss points; their number increases
 * as the distance decreases. A face with a node at the origin is divided into triangles that have
 * the origin as a corner, and the surface between its nodes is assumed to be smooth: along each ray
 * from the origin its height over the plane z = 0 grows with the square of the distance.
 * Boussinesq's tractions are then as weakly singular as on the smooth body that the facets
 * represent. On flat facets they would not be integrable.
 */
#ifndef palpate_FaceRule_h
#define palpate_FaceRule_h

#include <Eigen/Core>

#include <array>
#include <vector>

namespace palpate
{
/// The nodes of a face: 3 corners, 4 corners, or 3 corners and 3 mid-edge nodes. Coordinates
/// relative to the point of the force.
struct LocalFace
{
  int count = 0;
  Eigen::Matrix<double, 3, 6> nodes;
  int own = -1; ///< the node at the origin, or -1
};

/// One point of the quadrature.
struct FacePoint
{
  std::array<double, 6> shape{};
  Eigen::Vector3d at;
  Eigen::Vector3d area; ///< outward normal times weight, mm²
};

/// Computes the points of one face; `points` is overwritten.
void facePoints(const LocalFace& face, std::vector<FacePoint>& points);

/// Number of Gauss points in each direction for a cell whose middle is `distance` away and whose
/// farthest corner is `size` from the middle. The error of Boussinesq's stress is about 1e-3 of the
/// cell's contribution.
int pointsAlong(double distance, double size);
constexpr int MostPoints = 6; ///< largest result of pointsAlong()
} // namespace palpate

#endif
