// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SpaceForm_h
#define palpate_SpaceForm_h

#include "Laws/PointForm.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstddef>

namespace palpate
{
/// A second fundamental form in space. After a rotation it can be added to the form in another
/// tangent plane.
struct SpaceForm
{
  static constexpr std::size_t Square = 6; ///< index of the square of the mean curvature
  /// Index of the square of the roughness (SurfaceCurvature).
  static constexpr std::size_t Rough = 7;
  static constexpr std::size_t Count = 8; ///< index of the number of forms that were added

  /// The components xx, xy, xz, yy, yz, zz, followed by the values at Square, Rough and Count.
  std::array<double, 9> of{};

  SpaceForm() = default;
  /// Creates a single form from its components (t², tu, u²) in the tangent frame.
  SpaceForm(const Eigen::Vector3d& form, const TangentFrame& frame)
  {
    this->setMatrix(form[0] * frame.first * frame.first.transpose() +
      form[2] * frame.second * frame.second.transpose() +
      form[1] * (frame.first * frame.second.transpose() + frame.second * frame.first.transpose()));
    this->of[Square] = this->mean() * this->mean();
    this->of[Count] = 1.0;
  }

  double mean() const { return 0.5 * (this->of[0] + this->of[3] + this->of[5]); }

  Eigen::Matrix3d matrix() const
  {
    Eigen::Matrix3d matrix;
    matrix << this->of[0], this->of[1], this->of[2], this->of[1], this->of[3], this->of[4],
      this->of[2], this->of[4], this->of[5];
    return matrix;
  }

  /// Rotates the form by the smallest rotation from one normal to another.
  void turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to)
  {
    const Eigen::Vector3d axis = from.cross(to);
    const double cosine = from.dot(to);
    Eigen::Matrix3d cross;
    cross << 0.0, -axis.z(), axis.y(), axis.z(), 0.0, -axis.x(), -axis.y(), axis.x(), 0.0;
    const Eigen::Matrix3d rotation =
      Eigen::Matrix3d::Identity() + cross + cross * cross / (1.0 + cosine);
    this->setMatrix(rotation * this->matrix() * rotation.transpose());
  }

private:
  void setMatrix(const Eigen::Matrix3d& matrix)
  {
    this->of[0] = matrix(0, 0);
    this->of[1] = matrix(0, 1);
    this->of[2] = matrix(0, 2);
    this->of[3] = matrix(1, 1);
    this->of[4] = matrix(1, 2);
    this->of[5] = matrix(2, 2);
  }
};
} // namespace palpate

#endif
