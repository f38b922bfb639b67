// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SpatialVector_h
#define palpate_SpatialVector_h

#include <Eigen/Core>

#include <cmath>

namespace palpate
{
/**
 * A force with a torque, or a way with a turn, as one vector of six: torques are divided by a
 * length ℓ, turns multiplied with it, so that all is in N, or in m, and the product of a force and
 * a way is their work.
 *
 * With no angular part every result is that of the linear part alone, to the bit.
 */
struct SpatialVector
{
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();

  bool isAngular() const noexcept { return !this->angular.isZero(0.0); }
  double dot(const SpatialVector& other) const noexcept
  {
    return this->linear.dot(other.linear) + this->angular.dot(other.angular);
  }
  double squaredNorm() const noexcept
  {
    return this->linear.squaredNorm() + this->angular.squaredNorm();
  }
  double norm() const noexcept { return std::sqrt(this->squaredNorm()); }
  /// Whose squares neither overflow nor vanish.
  double stableNorm() const noexcept
  {
    const double straight = this->linear.stableNorm();
    return this->isAngular() ? std::hypot(straight, this->angular.stableNorm()) : straight;
  }

  SpatialVector& operator+=(const SpatialVector& other) noexcept
  {
    this->linear += other.linear;
    this->angular += other.angular;
    return *this;
  }
};

inline SpatialVector operator+(SpatialVector one, const SpatialVector& other) noexcept
{
  return one += other;
}

inline SpatialVector operator*(double factor, const SpatialVector& vector) noexcept
{
  return { factor * vector.linear, factor * vector.angular };
}

inline SpatialVector operator/(const SpatialVector& vector, double divisor) noexcept
{
  return { vector.linear / divisor, vector.angular / divisor };
}
} // namespace palpate

#endif
