// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ToolPose_h
#define palpate_ToolPose_h

#include <Eigen/Core>

namespace palpate
{
/// Where a tool is: the body's frame, mm.
struct ToolPose
{
  /// The axis is not known, and taken to be the body's normal.
  explicit ToolPose(const Eigen::Vector3d& at) noexcept
    : tip(at)
  {
  }
  /// `along`: any length; zero or not finite: unknown.
  ToolPose(const Eigen::Vector3d& at, const Eigen::Vector3d& along) noexcept
    : tip(at)
  {
    const double length = along.norm();
    if (length > 0.0 && along.allFinite())
    {
      this->axis = along / length;
    }
  }

  bool hasAxis() const noexcept { return !this->axis.isZero(0.0); }

  Eigen::Vector3d tip;                            ///< on the tool's axis
  Eigen::Vector3d axis = Eigen::Vector3d::Zero(); ///< unit, from the tip up the shaft; or zero
};
} // namespace palpate

#endif
