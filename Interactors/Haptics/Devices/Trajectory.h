// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_Trajectory_h
#define palpate_Trajectory_h

#include "Haptics/Devices/HapticDevice.h"
#include "Contact/ToolContact.h"

#include <vector>

namespace palpate
{
/// One line of a trajectory file.
struct TrajectoryRow
{
  double time = 0.0;                             ///< s
  Eigen::Vector3d tip = Eigen::Vector3d::Zero(); ///< body frame, mm

  /// The contact; zeros where there is none. Body frame; mm, N.
  Eigen::Vector3d contactPoint = Eigen::Vector3d::Zero();
  double deflection = 0.0;
  double normalForce = 0.0;
  Eigen::Vector3d friction = Eigen::Vector3d::Zero();
  double idealForce = 0.0; ///< magnitude of the total, before any limit of the device
  ContactState state = ContactState::None;

  /// The device, in its own frame; m, m/s, N.
  DeviceSample sample;
  Eigen::Vector3d sentForce = Eigen::Vector3d::Zero();
  bool isTaken = false; ///< by the device: the force

  /// A tick without a valid sample has no tip: it is (0, 0, 0), in state Invalid.
  bool hasTip() const noexcept
  {
    return this->state != ContactState::Invalid || !this->tip.isZero(0.0);
  }
};

/// What a trajectory file holds. Times are finite and do not decrease.
struct Trajectory
{
  std::vector<TrajectoryRow> rows;
  bool hasContact = false; ///< rows tell of the contact
  bool hasDevice = false;  ///< rows tell of the device
};
} // namespace palpate

#endif
