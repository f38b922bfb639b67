// SPDX-License-Identifier: BSD-3-Clause
#include "WorkspaceMapping.h"

namespace palpate
{
namespace
{
constexpr double MillimetresPerMetre = 1000.0;
}

WorkspaceMapping::WorkspaceMapping(
  const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation, double scale)
  : Rotation(rotation)
  , Translation(translation)
  , Scale(scale)
{
}

Eigen::Vector3d WorkspaceMapping::toBody(const Eigen::Vector3d& devicePosition) const noexcept
{
  return this->Rotation * (MillimetresPerMetre * this->Scale * devicePosition) + this->Translation;
}

Eigen::Vector3d WorkspaceMapping::toDevice(const Eigen::Vector3d& bodyPosition) const noexcept
{
  return this->Rotation.transpose() * (bodyPosition - this->Translation) /
    (MillimetresPerMetre * this->Scale);
}

Eigen::Vector3d WorkspaceMapping::forceToDevice(const Eigen::Vector3d& bodyForce) const noexcept
{
  return this->Rotation.transpose() * bodyForce;
}
} // namespace palpate
