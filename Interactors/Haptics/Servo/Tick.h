// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_Tick_h
#define palpate_Tick_h

#include "Haptics/Devices/HapticDevice.h"
#include "Contact/Contact.h"

#include <Eigen/Core>

#include <cstdint>

namespace palpate
{
/// What one step of the servo loop saw and did.
struct Tick
{
  double time = 0.0;                                     ///< s
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();         ///< body frame, mm
  Contact contact;                                       ///< body frame; the ideal force
  Eigen::Vector3d deviceForce = Eigen::Vector3d::Zero(); ///< device frame, N; what is sent

  Eigen::Vector3d velocity = Eigen::Vector3d::Zero(); ///< of the hand, body frame, mm/s
  /// What enters the safety chain, body frame, N: contact.force, but blended while a scene is left
  /// for another, and less while the clutch is at work.
  Eigen::Vector3d idealForce = Eigen::Vector3d::Zero();
  Eigen::Vector3d appliedForce = Eigen::Vector3d::Zero(); ///< deviceForce, body frame, N
  /// Of the tool, body frame, unit, from tip to hand; zero where the device does not tell it.
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  /// As the forces, about the tip: device frame, N m; body frame, N mm.
  Eigen::Vector3d deviceTorque = Eigen::Vector3d::Zero();
  Eigen::Vector3d idealTorque = Eigen::Vector3d::Zero();
  Eigen::Vector3d appliedTorque = Eigen::Vector3d::Zero();
  double forceFactor = 1.0; ///< of applied over ideal force (DeviceFit)
  double holdTime = 0.0;    ///< s: for so long deviceForce may be held (SafetyChain)
  /// How much of idealForce is of the scene that `contact` tells of: less than 1 during a ramp.
  double sceneShare = 1.0;
  std::uint32_t scene = 0; ///< which that is: how many changes came before
  std::uint32_t buttons = 0;
  std::uint16_t acted = 0; ///< sum of SafetyLink
  bool valid = false;      ///< the device told where it is
  bool fresh = false;      ///< and not for the second time
  bool clutched = false;   ///< the tip stays while the hand moves

  bool hasAxis() const noexcept { return !this->axis.isZero(0.0); }
  /// The force and torque that are sent.
  Wrench wrench() const noexcept { return { this->deviceForce, this->deviceTorque }; }
};
} // namespace palpate

#endif
