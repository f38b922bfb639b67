// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PointForm_h
#define palpate_PointForm_h

#include <Eigen/Core>

namespace palpate
{
/// Two unit tangents, orthogonal to each other and to a normal.
struct TangentFrame
{
  Eigen::Vector3d first;
  Eigen::Vector3d second;

  explicit TangentFrame(const Eigen::Vector3d& normal);
};

/// The second fundamental form of a surface at a point, in its tangent frame (t², tu, u²), 1/mm,
/// positive if convex. It is fitted in two ways: to the turns, which are the differences of the
/// normals along the edges, and to the sags, which are the depths of the neighbours below the
/// tangent plane.
struct PointForm
{
  Eigen::Vector3d byTurns = Eigen::Vector3d::Zero();
  Eigen::Vector3d bySags = Eigen::Vector3d::Zero();
  double residual = 0.0;   ///< root mean square residual of the turns
  double edgeSquare = 0.0; ///< mean square of the edge lengths, mm²

  /// Mean curvature by sags minus mean curvature by turns, 1/mm.
  double difference() const
  {
    return 0.5 * (this->bySags[0] + this->bySags[2] - this->byTurns[0] - this->byTurns[2]);
  }
};

/// Sums for the least-squares problem that fits a PointForm to the edges at a point.
class PointFormSums
{
public:
  explicit PointFormSums(const Eigen::Vector3d& normal);

  /// Adds the edge to a neighbour, mm. `turn` is the difference of the unit normals at both ends of
  /// the edge.
  void add(const Eigen::Vector3d& edge, const Eigen::Vector3d& turn);
  PointForm fit() const;

private:
  Eigen::Vector3d sagForm() const;

  Eigen::Vector3d Normal;
  TangentFrame Frame;
  // Sums over the edges, weighted by the squared length of each edge. p = (t², 2tu, u²) of the
  // direction of the edge.
  Eigen::Matrix3d Products = Eigen::Matrix3d::Zero(); ///< sum of p pᵀ
  /// Sum of p times the curvature that follows from the turn.
  Eigen::Vector3d Turns = Eigen::Vector3d::Zero();
  /// Sum of p times the curvature that follows from the sag.
  Eigen::Vector3d Sags = Eigen::Vector3d::Zero();
  double Square = 0.0; ///< sum of the squared curvatures that follow from the turns
  double Weight = 0.0;
  double Count = 0.0; ///< number of edges
  // The corresponding sums for a tilt of the tangent plane, which is fitted together with the sags.
  Eigen::Matrix<double, 3, 2> Mixed = Eigen::Matrix<double, 3, 2>::Zero();
  Eigen::Matrix2d Tilts = Eigen::Matrix2d::Zero();
  Eigen::Vector2d TiltSags = Eigen::Vector2d::Zero();
};
} // namespace palpate

#endif
