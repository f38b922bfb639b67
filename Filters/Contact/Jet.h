// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_Jet_h
#define palpate_Jet_h

#include <Eigen/Core>

namespace palpate
{
/**
 * The work of a pressed tool or a factor of this work, with its derivatives.
 *
 * Each effect on the contact (tilt, edges, border) is one factor with its own derivatives.
 * operator*= applies the product rule, for any combination of effects.
 */
struct Jet
{
  double value = 1.0;   ///< a work in N mm, or a factor without unit
  double byDepth = 0.0; ///< first derivative with respect to the depth; for a work: the force, N
  /// Second derivative with respect to the depth; for a work: the stiffness, N/mm.
  double byDepthTwice = 0.0;
  /// Derivative with respect to the tilt at constant depth; for a work: N mm per rad.
  double byTilt = 0.0;
  /// Gradient with respect to the tip's position at constant depth and tilt, 1/mm; for a work: N.
  Eigen::Vector3d byPlace = Eigen::Vector3d::Zero();

  Jet& operator*=(const Jet& factor) noexcept
  {
    this->byPlace = this->byPlace * factor.value + this->value * factor.byPlace;
    this->byTilt = this->byTilt * factor.value + this->value * factor.byTilt;
    this->byDepthTwice = this->byDepthTwice * factor.value + 2.0 * this->byDepth * factor.byDepth +
      this->value * factor.byDepthTwice;
    this->byDepth = this->byDepth * factor.value + this->value * factor.byDepth;
    this->value *= factor.value;
    return *this;
  }
  Jet& operator+=(const Jet& other) noexcept
  {
    this->value += other.value;
    this->byDepth += other.byDepth;
    this->byDepthTwice += other.byDepthTwice;
    this->byTilt += other.byTilt;
    this->byPlace += other.byPlace;
    return *this;
  }
};
} // namespace palpate

#endif
