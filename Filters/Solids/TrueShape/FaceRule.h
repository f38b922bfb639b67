// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * Quadrature of a field that is singular at the origin over one face of an element.
 *
 * A face that does not hold the origin takes Gauss points, the more the nearer it is. One that has
 * it for a node is cut into triangles with that corner, and the surface between its nodes is taken
 * to be smooth: along each ray from the origin it leaves the plane z = 0 as the square of the way,
 * so that Boussinesq's tractions on it stay as weak as on the body that the facets stand for (on
 * flat facets they would not be integrable).
 */
#ifndef palpate_FaceRule_h
#define palpate_FaceRule_h

#include <Eigen/Core>

#include <array>
#include <vector>

namespace palpate
{
/// The nodes of a face: 3 corners, 4, or 3 corners and 3 mid-edge nodes; seen from where the force
/// is.
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

/// The points of one face; `points` is overwritten.
void facePoints(const LocalFace& face, std::vector<FacePoint>& points);

/// How many Gauss points along each direction a cell needs whose middle is `distance` away and
/// whose farthest corner is `size` from the middle: the error of Boussinesq's stress stays near
/// 1e-3 of what the cell contributes.
int pointsAlong(double distance, double size);
constexpr int MostPoints = 6; ///< that it asks for
} // namespace palpate

#endif
