// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_WorkspaceMapping_h
#define palpate_WorkspaceMapping_h

#include <Eigen/Core>

namespace palpate
{
/**
 * From the frame of the device (m) to the frame of the body (mm) and back: the only place where
 * units change. x_body = R (1000 scale x_device) + t; forces keep their magnitude, so a stiffness K
 * of the body is felt as `scale` K.
 */
class WorkspaceMapping
{
public:
  WorkspaceMapping() = default;
  /// `rotation` must be orthonormal, `scale` positive, `translation` in mm.
  WorkspaceMapping(
    const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation, double scale);

  Eigen::Vector3d toBody(const Eigen::Vector3d& devicePosition) const noexcept;
  Eigen::Vector3d toDevice(const Eigen::Vector3d& bodyPosition) const noexcept;
  Eigen::Vector3d forceToDevice(const Eigen::Vector3d& bodyForce) const noexcept;
  double scale() const noexcept { return this->Scale; }

private:
  Eigen::Matrix3d Rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d Translation = Eigen::Vector3d::Zero();
  double Scale = 1.0;
};
} // namespace palpate

#endif
