// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_WorkspaceMapping_h
#define palpate_WorkspaceMapping_h

#include "Contact/SettingFault.h"
#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

namespace palpate
{
constexpr double MillimetresPerMetre = 1000.0;

/**
 * Maps the frame of the device (m) to the frame of the body (mm) and back; no other class converts
 * these units. x_body = R (1000 scale x_device) + t. Forces keep their magnitude, so that a
 * stiffness K of the body is `scale` K for the hand.
 *
 * An axis is rotated by R, a torque by det R Rᵀ, because a reflection reverses its sign. Angles are
 * equal in both frames, so that a torque is divided by the factor of lengths: M_device (N m) = det
 * R Rᵀ M_body (N mm) / (1000 scale). The work at the device (J) is then that in the body (N mm)
 * divided by 1000 scale, for F · v as well as for M · ω. Therefore a passive scene is passive for
 * the hand.
 *
 * A planar device (two axes) moves along its x and y: z is ignored, and only the component of a
 * force in the plane acts on the hand. In the body, this plane passes through `translation` and is
 * spanned by the first two columns of the rotation. Only the component of a torque about z acts on
 * the hand.
 */
class PALPATE_EXPORT WorkspaceMapping
{
public:
  WorkspaceMapping() = default;
  /// `rotation` must be orthonormal (its columns are the axes of the device in the body's frame;
  /// the determinant is -1 for a device with left-handed axes), `scale` positive, `translation` in
  /// mm.
  WorkspaceMapping(
    const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation, double scale);
  /// The mapping of a planar device: the plane passes through `origin` (mm); the device's x is
  /// along `right` and its y along `up`, orthogonal unit vectors in the body's frame.
  static WorkspaceMapping inPlane(const Eigen::Vector3d& origin, const Eigen::Vector3d& right,
    const Eigen::Vector3d& up, double scale);

  /// The same mapping, for a planar device.
  WorkspaceMapping planar() const noexcept;
  /// A mapping with the same axes and the smallest scale for which the workspace, with the half
  /// extents `workspace` (m), contains a body's box (mm, corner to corner) with a free `margin`
  /// (mm, >= 0) around it. Both have the same centre. For a planar device only x and y of the
  /// workspace are used, and the plane intersects the box at its centre. For an invalid box or
  /// workspace the resulting scale has a fault.
  WorkspaceMapping fitted(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper,
    const Eigen::Vector3d& workspace, double margin) const noexcept;

  /// The fault of the first of Rotation, Translation and Scale that is not finite or out of its
  /// range. The rotation must be orthonormal to RotationTolerance.
  SettingFault fault() const;
  static constexpr double RotationTolerance = 1e-6; ///< tolerance of RᵀR, for numbers with 7 digits

  Eigen::Vector3d toBody(const Eigen::Vector3d& devicePosition) const noexcept;
  Eigen::Vector3d toDevice(const Eigen::Vector3d& bodyPosition) const noexcept;
  /// Converts m/s to mm/s.
  Eigen::Vector3d velocityToBody(const Eigen::Vector3d& deviceVelocity) const noexcept;
  Eigen::Vector3d forceToDevice(const Eigen::Vector3d& bodyForce) const noexcept;
  Eigen::Vector3d forceToBody(const Eigen::Vector3d& deviceForce) const noexcept;
  /// Converts a unit vector to a unit vector.
  Eigen::Vector3d axisToBody(const Eigen::Vector3d& deviceAxis) const noexcept;
  Eigen::Vector3d axisToDevice(const Eigen::Vector3d& bodyAxis) const noexcept;
  /// Converts N mm to N m, and back.
  Eigen::Vector3d torqueToDevice(const Eigen::Vector3d& bodyTorque) const noexcept;
  Eigen::Vector3d torqueToBody(const Eigen::Vector3d& deviceTorque) const noexcept;
  /// The components of a position, velocity or force (frame of the device) that the device has:
  /// without z if it is planar.
  Eigen::Vector3d inReach(const Eigen::Vector3d& deviceVector) const noexcept;
  /// Converts mm to m.
  double lengthToDevice(double bodyLength) const noexcept;
  /// Converts N/mm to N/m: a stiffness of the body as the device must render it.
  double stiffnessToDevice(double bodyStiffness) const noexcept;

  const Eigen::Matrix3d& rotation() const noexcept { return this->Rotation; }
  const Eigen::Vector3d& translation() const noexcept { return this->Translation; }
  double scale() const noexcept { return this->Scale; }
  bool isPlanar() const noexcept { return this->Planar; }

private:
  Eigen::Matrix3d Rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d Translation = Eigen::Vector3d::Zero();
  double Scale = 1.0;
  double Handedness = 1.0; ///< the sign of det R
  bool Planar = false;
};
} // namespace palpate

#endif
