// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_Trajectory_h
#define palpate_Trajectory_h

#include "Haptics/Devices/HapticDevice.h"
#include "Contact/Contact.h"

#include <vector>

namespace palpate
{
/// One line of a trajectory file.
struct TrajectoryRow
{
  double time = 0.0;                             ///< s
  Eigen::Vector3d tip = Eigen::Vector3d::Zero(); ///< body frame, mm
  /// Axis of the tool, from tip to hand, body frame, unit; zero: unknown.
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();

  /// A file has only its point, deflection, normal force, memory, friction, torque and state.
  Contact contact;
  double idealForce = 0.0; ///< magnitude of the total force before any limit of the device, N

  /// The device, in its own frame; m, m/s, N.
  DeviceSample sample;
  Eigen::Vector3d sentForce = Eigen::Vector3d::Zero();
  bool isTaken = false; ///< whether the device accepted the force

  /// A tick without a valid sample has no tip: `tip` is (0, 0, 0), and the state is Invalid.
  bool hasTip() const noexcept
  {
    return this->contact.state != ContactState::Invalid || !this->tip.isZero(0.0);
  }
};

/// The content of a trajectory file. Times are finite and do not decrease.
struct Trajectory
{
  std::vector<TrajectoryRow> rows;
  bool hasContact = false; ///< rows have the contact
  bool hasDevice = false;  ///< rows have the device
  bool hasAxis = false;    ///< rows have the tool's axis
  bool hasTorque = false;  ///< rows have the torque of the contact
  bool hasMemory = false;  ///< rows have the memory part of the contact's force
};
} // namespace palpate

#endif
