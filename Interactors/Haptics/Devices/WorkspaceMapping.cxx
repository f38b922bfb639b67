// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Devices/WorkspaceMapping.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace palpate
{
WorkspaceMapping::WorkspaceMapping(
  const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation, double scale)
  : Rotation(rotation)
  , Translation(translation)
  , Scale(scale)
  , Handedness(rotation.determinant() < 0.0 ? -1.0 : 1.0)
{
}

WorkspaceMapping WorkspaceMapping::inPlane(const Eigen::Vector3d& origin,
  const Eigen::Vector3d& right, const Eigen::Vector3d& up, double scale)
{
  Eigen::Matrix3d rotation;
  rotation << right, up, right.cross(up);
  return WorkspaceMapping(rotation, origin, scale).planar();
}

WorkspaceMapping WorkspaceMapping::planar() const noexcept
{
  WorkspaceMapping flat = *this;
  flat.Planar = true;
  return flat;
}

WorkspaceMapping WorkspaceMapping::fitted(const Eigen::Vector3d& lower,
  const Eigen::Vector3d& upper, const Eigen::Vector3d& workspace, double margin) const noexcept
{
  // Half extents of the body's box along the axes of the device.
  const Eigen::Vector3d half = this->Rotation.transpose().cwiseAbs() * (0.5 * (upper - lower));
  const bool isSound =
    (upper - lower).minCoeff() >= 0.0 && margin >= 0.0 && half.allFinite() && std::isfinite(margin);
  WorkspaceMapping fit = *this;
  fit.Translation = 0.5 * (lower + upper);
  fit.Scale = isSound ? 0.0 : std::numeric_limits<double>::quiet_NaN();
  for (int axis = 0; axis < (this->Planar ? 2 : 3); ++axis)
  {
    const double reach = MillimetresPerMetre * workspace[axis];
    const double scale =
      reach > 0.0 ? (half[axis] + margin) / reach : std::numeric_limits<double>::quiet_NaN();
    fit.Scale = std::isnan(scale) ? scale : std::max(fit.Scale, scale);
  }
  return fit;
}

SettingFault WorkspaceMapping::fault() const
{
  const Eigen::Matrix3d defect =
    this->Rotation.transpose() * this->Rotation - Eigen::Matrix3d::Identity();
  const double largest = defect.cwiseAbs().maxCoeff();
  if (!this->Rotation.allFinite() || !(largest <= RotationTolerance))
  {
    std::ostringstream remark;
    remark << "must be orthonormal, but RᵀR is off by " << largest;
    return { "Rotation", remark.str() };
  }
  if (!this->Translation.allFinite())
  {
    return SettingFault::must("Translation", "be finite (mm)", this->Translation.transpose());
  }
  if (!(this->Scale > 0.0) || !std::isfinite(this->Scale))
  {
    return SettingFault::must("Scale", "be finite and positive", this->Scale);
  }
  return {};
}

[[gnu::hot]] Eigen::Vector3d WorkspaceMapping::inReach(
  const Eigen::Vector3d& deviceVector) const noexcept
{
  return { deviceVector.x(), deviceVector.y(), this->Planar ? 0.0 : deviceVector.z() };
}

[[gnu::hot]] Eigen::Vector3d WorkspaceMapping::toBody(
  const Eigen::Vector3d& devicePosition) const noexcept
{
  return this->Rotation * (MillimetresPerMetre * this->Scale * this->inReach(devicePosition)) +
    this->Translation;
}

Eigen::Vector3d WorkspaceMapping::toDevice(const Eigen::Vector3d& bodyPosition) const noexcept
{
  return this->inReach(this->Rotation.transpose() * (bodyPosition - this->Translation)) /
    (MillimetresPerMetre * this->Scale);
}

[[gnu::hot]] Eigen::Vector3d WorkspaceMapping::velocityToBody(
  const Eigen::Vector3d& deviceVelocity) const noexcept
{
  return this->Rotation * (MillimetresPerMetre * this->Scale * this->inReach(deviceVelocity));
}

[[gnu::hot]] Eigen::Vector3d WorkspaceMapping::forceToDevice(
  const Eigen::Vector3d& bodyForce) const noexcept
{
  return this->inReach(this->Rotation.transpose() * bodyForce);
}

[[gnu::hot]] Eigen::Vector3d WorkspaceMapping::forceToBody(
  const Eigen::Vector3d& deviceForce) const noexcept
{
  return this->Rotation * this->inReach(deviceForce);
}

Eigen::Vector3d WorkspaceMapping::axisToBody(const Eigen::Vector3d& deviceAxis) const noexcept
{
  return this->Rotation * deviceAxis;
}

Eigen::Vector3d WorkspaceMapping::axisToDevice(const Eigen::Vector3d& bodyAxis) const noexcept
{
  return this->Rotation.transpose() * bodyAxis;
}

Eigen::Vector3d WorkspaceMapping::torqueToDevice(const Eigen::Vector3d& bodyTorque) const noexcept
{
  const Eigen::Vector3d torque = this->Handedness / (MillimetresPerMetre * this->Scale) *
    (this->Rotation.transpose() * bodyTorque);
  return this->Planar ? Eigen::Vector3d(0.0, 0.0, torque.z()) : torque;
}

Eigen::Vector3d WorkspaceMapping::torqueToBody(const Eigen::Vector3d& deviceTorque) const noexcept
{
  return this->Handedness * MillimetresPerMetre * this->Scale * (this->Rotation * deviceTorque);
}

[[gnu::hot]] double WorkspaceMapping::lengthToDevice(double bodyLength) const noexcept
{
  return bodyLength / (MillimetresPerMetre * this->Scale);
}

double WorkspaceMapping::stiffnessToDevice(double bodyStiffness) const noexcept
{
  return MillimetresPerMetre * this->Scale * bodyStiffness;
}
} // namespace palpate
