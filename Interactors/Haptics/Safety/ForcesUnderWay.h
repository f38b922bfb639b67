// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ForcesUnderWay_h
#define palpate_ForcesUnderWay_h

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace palpate
{
/**
 * A force with a torque, or a displacement with a rotation, as one vector of six: torques are
 * divided by a length ℓ, rotations multiplied by it, so that all is in N, or in m, and the product
 * of both is the work.
 *
 * Without angular part every result is that of the linear part alone, to the bit.
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
  /// Norm without overflow or underflow of the squares.
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

/**
 * The forces sent last, any of which may be acting now if a device's readings and forces are late
 * by up to a number of ticks. None is kept without delay.
 */
class ForcesUnderWay
{
public:
  static constexpr std::size_t Most = 32; ///< ticks of delay

  /// `delay` and `period` in s; more than Most ticks count as Most, NaN as none.
  ForcesUnderWay(double delay, double period) noexcept
    : Late(delay > 0.0 && period > 0.0
          ? static_cast<std::size_t>(std::ceil(std::min(delay / period, 1.0 * Most) - 1e-9))
          : 0)
  {
    this->Forces.fill({});
  }

  std::size_t late() const noexcept { return this->Late; }

  void sent(const SpatialVector& force) noexcept
  {
    this->Newest = (this->Newest + 1) % this->Forces.size();
    this->Forces[this->Newest] = force;
  }

  /// The most energy that the hand may have got over a displacement (m) within `ticks`, J; may be
  /// negative.
  double mostGiven(const SpatialVector& moved, std::size_t ticks) const noexcept
  {
    double most = this->at(0).dot(moved);
    for (std::size_t i = 1; i < std::min(this->Late + ticks, this->Forces.size()); ++i)
    {
      most = std::max(most, this->at(i).dot(moved));
    }
    return most;
  }

  /**
   * The largest force f such that Σ max(|F_i|, f)² over the coming late() + 1 holds is within
   * `square`, |F_i| the largest force that may still act i holds from now; 0 if there is none.
   */
  double largestWithin(double square) const noexcept
  {
    // largest[i]: the largest of the forces sent within the last late() - i ticks; in the last hold
    // only the new one acts.
    std::array<double, Most + 1> largest{};
    for (std::size_t i = this->Late; i-- > 0;)
    {
      largest[i] = std::max(largest[i + 1], this->at(this->Late - 1 - i).norm());
    }
    // From the strongest down: the rest is shared by the holds with weaker forces.
    double left = square;
    for (std::size_t i = 0; i <= this->Late; ++i)
    {
      const double most = std::sqrt(std::max(0.0, left) / static_cast<double>(this->Late + 1 - i));
      if (most >= largest[i])
      {
        return most;
      }
      left -= largest[i] * largest[i];
    }
    return 0.0;
  }

private:
  /// The force sent `age` ticks before the last one.
  const SpatialVector& at(std::size_t age) const noexcept
  {
    return this->Forces[(this->Newest + this->Forces.size() - age) % this->Forces.size()];
  }

  std::size_t Late;
  std::size_t Newest = 0;
  std::array<SpatialVector, 2 * Most> Forces;
};
} // namespace palpate

#endif
