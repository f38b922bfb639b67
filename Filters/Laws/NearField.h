// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_NearField_h
#define palpate_NearField_h

#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <array>

namespace palpate
{
/**
 * The part of the response of a body around a point X of its surface that its modes (GlobalModes)
 * do not describe: the effect of an edge, a base or a nodule. R(d) is the inward displacement of
 * the surface at X + d caused by 1 N at X, in addition to the dent in a half-space. d is a vector
 * in the tangent plane at X.
 *   R(d) = κ² [R₀ + κ g·d + κ² d·Q d],  κ = min(1, ρ/|d|).
 * R is known up to the radius ρ. Beyond ρ it decreases with the square of the distance.
 */
struct NearField
{
  static constexpr std::size_t Numbers = 12; ///< number of values in the stored array

  double depth = 0.0;                              ///< R₀, mm/N
  Eigen::Vector3d slope = Eigen::Vector3d::Zero(); ///< g, 1/N
  Eigen::Matrix3d bend = Eigen::Matrix3d::Zero();  ///< Q, 1/(N mm), symmetric
  double radius = 0.0;                             ///< ρ, mm; 0 if it is unknown
  double reducedModulus = 0.0;                     ///< E* of the half-space, MPa

  /// Returns R(d), mm/N. `away` is d, mm.
  PALPATE_EXPORT double at(const Eigen::Vector3d& away) const;
};

/// Order of the stored numbers: g, R₀; Q xx, yy, zz, ρ; Q xy, yz, zx, E*.
PALPATE_EXPORT std::array<double, NearField::Numbers> numbersOf(const NearField& near);
PALPATE_EXPORT NearField nearFieldOf(const std::array<double, NearField::Numbers>& numbers);
} // namespace palpate

#endif
