// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ToolOrientation_h
#define palpate_ToolOrientation_h

#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>

namespace palpate
{
/**
 * The orientation of a tool, as a unit quaternion: the rotation from the tool's own frame into the
 * device frame. The +z axis of the tool's frame is the shaft, from the tip to the hand. All
 * components are zero if the orientation is unknown.
 */
using ToolOrientation = Eigen::Quaternion<double, Eigen::DontAlign>;

inline ToolOrientation orientationNotTold() noexcept
{
  return { 0.0, 0.0, 0.0, 0.0 };
}

/// Whether the orientation is known, which means that it is not zero. The quaternion need not have
/// unit length. NaN counts as known.
inline bool isTold(const ToolOrientation& orientation) noexcept
{
  return !orientation.coeffs().isZero(0.0);
}

/// The direction of the shaft, from tip to hand, as a unit vector in the device frame. Zero if the
/// orientation is unknown or not finite.
inline Eigen::Vector3d shaftOf(const ToolOrientation& orientation) noexcept
{
  const double length = orientation.norm();
  if (!(length > 0.0 && std::isfinite(length)))
  {
    return Eigen::Vector3d::Zero();
  }
  ToolOrientation unit = orientation;
  unit.coeffs() /= length;
  return unit * Eigen::Vector3d::UnitZ();
}

/// Returns the smallest rotation that makes the shaft parallel to `axis`. The axis need not have
/// unit length. The result is the unknown orientation if `axis` is zero or not finite.
PALPATE_EXPORT ToolOrientation orientationAlong(const Eigen::Vector3d& axis) noexcept;

/// Converts a rotation vector to a rotation. The direction of the vector is the axis, its length is
/// the angle, rad.
inline ToolOrientation turnedBy(const Eigen::Vector3d& rotation) noexcept
{
  const double angle = rotation.norm();
  const double half = 0.5 * angle;
  // sin(half)/angle; a power series, exact to rounding, for small angles
  const double share = angle > 1e-5 ? std::sin(half) / angle : 0.5 - half * half / 12.0;
  const Eigen::Vector3d vector = share * rotation;
  return { std::cos(half), vector.x(), vector.y(), vector.z() };
}

/// The smallest rotation from one axis to another, as a rotation vector, rad. The axes need not
/// have unit length but must not be zero. For opposite axes, the rotation is about an arbitrary
/// perpendicular axis.
inline Eigen::Vector3d leastTurn(const Eigen::Vector3d& from, const Eigen::Vector3d& to) noexcept
{
  const Eigen::Vector3d across = from.cross(to);
  const double sine = across.norm();
  const double cosine = from.dot(to);
  if (sine > 1e-12 * std::abs(cosine))
  {
    return std::atan2(sine, cosine) / sine * across;
  }
  constexpr double Half = 3.14159265358979323846;
  return cosine < 0.0 ? Eigen::Vector3d(Half * from.unitOrthogonal())
                      : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

/// The smallest rotation from one known orientation to another, as a rotation vector in the
/// device's frame, rad.
inline Eigen::Vector3d turnBetween(const ToolOrientation& from, const ToolOrientation& to) noexcept
{
  const ToolOrientation turn = to * from.conjugate();
  const double sine = turn.vec().norm();
  const double cosine = std::abs(turn.w());
  // atan2(s, c)/s, which tends to 1/c for small s
  const double share = sine > 1e-9 * cosine ? std::atan2(sine, cosine) / sine : 1.0 / cosine;
  return std::copysign(2.0 * share, turn.w()) * turn.vec();
}
} // namespace palpate

#endif
