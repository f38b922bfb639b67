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
 * Maps the device frame (m) to the body frame (mm) and back: x_body = R (1000 scale x_device) + t.
 * No other class converts these units. The magnitude of forces is unchanged, so that a stiffness K
 * of the body becomes `scale` K at the hand.
 *
 * An axis is rotated by R. A torque is multiplied by det R Rᵀ, because a reflection reverses the
 * sign of a torque. Angles are equal in both frames, so that a torque is divided by the factor of
 * lengths: M_device (N m) = det R Rᵀ M_body (N mm) / (1000 scale). Then the work at the device (J)
 * is the work in the body frame (N mm) divided by 1000 scale, for F · v as well as for M · ω.
 * Therefore a passive scene is passive for the hand.
 *
 * A planar device has two axes, x and y. Its z is ignored, and only the component of a force in the
 * plane acts on the hand. In the body, this plane passes through `translation` and is spanned by
 * the first two columns of the rotation. Only the component of a torque about z acts on the hand.
 */
class PALPATE_EXPORT WorkspaceMapping
{
public:
  WorkspaceMapping() = default;
  /// `rotation` must be orthonormal. Its columns are the axes of the device in the body frame; its
  /// determinant is -1 for a device with left-handed axes. `scale` must be positive. `translation`
  /// is in mm.
  WorkspaceMapping(
    const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation, double scale);
  /// Returns the mapping of a planar device whose plane passes through `origin` (mm). The device's
  /// x axis is along `right` and its y axis along `up`; both are orthogonal unit vectors in the
  /// body frame.
  static WorkspaceMapping inPlane(const Eigen::Vector3d& origin, const Eigen::Vector3d& right,
    const Eigen::Vector3d& up, double scale);

  /// Returns the same mapping for a planar device.
  WorkspaceMapping planar() const noexcept;
  /// Returns a mapping with the same axes, centred on a body's box, and with the smallest scale for
  /// which the workspace contains the box. `lower` and `upper` are the corners of the box, mm.
  /// `workspace` contains the half extents of the workspace, m. `margin` (mm, >= 0) is kept free
  /// around the box. For a planar device only x and y of the workspace are used, and the plane
  /// intersects the box at its centre. If the box or the workspace is invalid, the scale of the
  /// result is out of its range, which fault() reports.
  WorkspaceMapping fitted(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper,
    const Eigen::Vector3d& workspace, double margin) const noexcept;

  /// The fault of the first of Rotation, Translation and Scale that is not finite or out of its
  /// range. The rotation must be orthonormal within RotationTolerance.
  SettingFault fault() const;
  /// Tolerance of RᵀR; permits numbers with 7 digits.
  static constexpr double RotationTolerance = 1e-6;

  Eigen::Vector3d toBody(const Eigen::Vector3d& devicePosition) const noexcept;
  Eigen::Vector3d toDevice(const Eigen::Vector3d& bodyPosition) const noexcept;
  /// Converts a velocity from m/s to mm/s.
  Eigen::Vector3d velocityToBody(const Eigen::Vector3d& deviceVelocity) const noexcept;
  Eigen::Vector3d forceToDevice(const Eigen::Vector3d& bodyForce) const noexcept;
  Eigen::Vector3d forceToBody(const Eigen::Vector3d& deviceForce) const noexcept;
  /// Converts an axis, a unit vector, to a unit vector.
  Eigen::Vector3d axisToBody(const Eigen::Vector3d& deviceAxis) const noexcept;
  Eigen::Vector3d axisToDevice(const Eigen::Vector3d& bodyAxis) const noexcept;
  /// Converts a torque between N mm in the body frame and N m in the device frame.
  Eigen::Vector3d torqueToDevice(const Eigen::Vector3d& bodyTorque) const noexcept;
  Eigen::Vector3d torqueToBody(const Eigen::Vector3d& deviceTorque) const noexcept;
  /// Returns a position, velocity or force of the device frame without the components that the
  /// device lacks: z is zero for a planar device.
  Eigen::Vector3d inReach(const Eigen::Vector3d& deviceVector) const noexcept;
  /// Converts a length from mm to m.
  double lengthToDevice(double bodyLength) const noexcept;
  /// Converts the stiffness of the body (N/mm) to the stiffness that the device must render (N/m).
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
