// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_NearField_h
#define palpate_NearField_h

#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <array>

namespace palpate
{
/**
 * What the modes of a body (GlobalModes) leave of its H around a point X of its surface: the pull
 * of an edge, the stop of a base, a nodule. How far the surface at X + d goes in by 1 N pressed
 * into it at X, beside the dent of a half-space, d along the surface in the tangent plane at X:
 *   R(d) = κ² [R₀ + κ g·d + κ² d·Q d],  κ = min(1, ρ/|d|).
 * It is known up to ρ; beyond, it falls off with the square of the distance.
 */
struct NearField
{
  static constexpr std::size_t Numbers = 12; ///< that it is stored as

  double depth = 0.0;                              ///< R₀, mm/N
  Eigen::Vector3d slope = Eigen::Vector3d::Zero(); ///< g, 1/N
  Eigen::Matrix3d bend = Eigen::Matrix3d::Zero();  ///< Q, 1/(N mm), symmetric
  double radius = 0.0;                             ///< ρ, mm; 0: nothing is known
  double reducedModulus = 0.0;                     ///< of the half-space, MPa

  /// R(d), mm/N.
  PALPATE_EXPORT double at(const Eigen::Vector3d& away) const;
};

/// As it is stored: g, R₀; Q xx, yy, zz, ρ; Q xy, yz, zx, E*.
PALPATE_EXPORT std::array<double, NearField::Numbers> numbersOf(const NearField& near);
PALPATE_EXPORT NearField nearFieldOf(const std::array<double, NearField::Numbers>& numbers);
} // namespace palpate

#endif
