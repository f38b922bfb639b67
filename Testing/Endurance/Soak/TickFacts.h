// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_TickFacts_h
#define palpate_endurance_TickFacts_h

#include "Haptics/Devices/HapticDevice.h"
#include "RoundBody.h"
#include "ToolLaw.h"

#include <cstdint>
#include <memory>

namespace palpate
{
struct Tick;
}

namespace palpate::endurance
{
/// One scene in contact: a body, a tool and the friction.
struct FeltScene
{
  std::shared_ptr<const RoundBody> body;
  ToolLaw tool{ ToolLaw::Flat, 1.0 };
  double friction = 0.0; ///< Coulomb's coefficient
  /// P: relative excess of a relaxing body's instantaneous modulus over its slow modulus. 0:
  /// elastic.
  double relaxation = 0.0;
  int elements = 16; ///< number of relaxation elements of the servo step
};

/// Transform from the device's frame to the body's frame: x = axes (1000 scale x_device) + origin.
struct DeviceFrame
{
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< orthonormal
  Vector3 origin = Vector3::Zero();                   ///< mm
  double scale = 1.0;

  Vector3 tip(const Vector3& position) const
  {
    return this->axes * (1000.0 * this->scale * position) + this->origin;
  }
  Vector3 position(const Vector3& tip) const
  {
    return this->axes.transpose() * (tip - this->origin) / (1000.0 * this->scale);
  }
};

/// One tick. The sample and the sent force are recorded at the device itself; the loop reports the
/// other members.
struct TickFacts
{
  double time = 0.0; ///< time passed to the device, s
  DeviceSample sample;
  Vector3 sent = Vector3::Zero(); ///< force passed to the device, N, device frame

  std::uint32_t scene = 0;                ///< number of scene changes before this tick
  double sceneShare = 1.0;                ///< share of this scene in the ideal force
  Vector3 tip = Vector3::Zero();          ///< mm, body frame, like the members below
  Vector3 contactForce = Vector3::Zero(); ///< force from this scene, N
  Vector3 idealForce = Vector3::Zero();   ///< force from all scenes in contact, N
  Vector3 saidSent = Vector3::Zero();     ///< force recorded as sent, N, device frame
  bool isPassivityLimited = false;        ///< whether the passivity control reduced the force
};

/// Combines the record of the device and the loop's report of the same tick.
TickFacts factsOf(double time, const DeviceSample& sample, const Vector3& sent, const Tick& tick);
} // namespace palpate::endurance

#endif
