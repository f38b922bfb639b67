// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * Quadrature, over one face of an element, of a field that is singular at the origin.
 *
 * A face that does not contain the origin is integrated with Gauss points. Their number increases
 * as the distance from the origin decreases. A face with a node at the origin is divided into
 * triangles that have the origin as a corner. The surface between the nodes is assumed to be
 * smooth: along each ray from the origin, its height over the plane z = 0 grows with the square of
 * the distance. Boussinesq's tractions are then as weakly singular as on the smooth body that the
 * facets represent. On flat facets, the tractions would not be integrable.
 */
#ifndef palpate_FaceRule_h
#define palpate_FaceRule_h

#include <Eigen/Core>

#include <array>
#include <vector>

namespace palpate
{
/// The nodes of a face: 3 corners, 4 corners, or 3 corners and 3 mid-edge nodes. Coordinates are
/// relative to the point of the force.
struct LocalFace
{
  int count = 0;
  Eigen::Matrix<double, 3, 6> nodes;
  int own = -1; ///< index of the node at the origin, or -1
};

/// One point of the quadrature.
struct FacePoint
{
  std::array<double, 6> shape{};
  Eigen::Vector3d at;
  Eigen::Vector3d area; ///< outward normal times weight, mm²
};

/// Computes the quadrature points of one face. `points` is overwritten.
void facePoints(const LocalFace& face, std::vector<FacePoint>& points);

/// Returns the number of Gauss points in each direction for a cell. `distance` is the distance of
/// its middle from the origin. `size` is the distance of its farthest corner from its middle. The
/// error of Boussinesq's stress is about 1e-3 of the cell's contribution.
int pointsAlong(double distance, double size);
constexpr int MostPoints = 6; ///< largest result of pointsAlong()
} // namespace palpate

#endif
