// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_Trajectory_h
#define palpate_Trajectory_h

#include "Haptics/Devices/HapticDevice.h"
#include "Haptics/Devices/RecordedSetup.h"
#include "Contact/Contact.h"

#include <vector>

namespace palpate
{
/// One line of a trajectory file.
struct TrajectoryRow
{
  double time = 0.0;                             ///< s
  Eigen::Vector3d tip = Eigen::Vector3d::Zero(); ///< body frame, mm
  /// Axis of the tool, from tip to hand, as a unit vector in the body frame; zero if unknown.
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();

  /// The contact. A file contains only its point, deflection, normal force, memory force, friction,
  /// torque and state.
  Contact contact;
  /// Magnitude of the total force of `contact`, N, before any limit of the device. During a change
  /// of the scene, idealForce is the force of the new scene alone, while `sentForce` changes
  /// gradually from the force of the old scene to that of the new one.
  double idealForce = 0.0;

  /// The device's reading in the device frame, m and m/s, and the force that was sent, N.
  DeviceSample sample;
  Eigen::Vector3d sentForce = Eigen::Vector3d::Zero();
  bool isTaken = false; ///< whether the device accepted the force

  /// Whether the tick has a tip. If the sample of a tick is not valid, `tip` is (0, 0, 0) and the
  /// state is Invalid.
  bool hasTip() const noexcept
  {
    return this->contact.state != ContactState::Invalid || !this->tip.isZero(0.0);
  }
};

/// The content of a trajectory file. Times are finite and do not decrease.
struct Trajectory
{
  std::vector<TrajectoryRow> rows;
  RecordedSetups setups;   ///< body, tool and material; times as in the rows
  bool hasContact = false; ///< whether rows contain the contact
  bool hasDevice = false;  ///< whether rows contain the device's reading
  bool hasAxis = false;    ///< whether rows contain the tool's axis
  bool hasTorque = false;  ///< whether rows contain the torque of the contact
  bool hasMemory = false;  ///< whether rows contain the memory force of the contact
};
} // namespace palpate

#endif
