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
/// A body, a tool and the resistance to sliding: one scene in contact.
struct FeltScene
{
  std::shared_ptr<const RoundBody> body;
  ToolLaw tool{ ToolLaw::Flat, 1.0 };
  double friction = 0.0; ///< Coulomb's coefficient
  /// P: relative excess of the instantaneous modulus of a relaxing body over the slow one. 0:
  /// elastic.
  double relaxation = 0.0;
  int elements = 16; ///< number of relaxation elements of the servo step
};

/// From the device's frame to the body's: x = axes (1000 scale x_device) + origin.
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

/// One tick. The sample and the sent force are recorded at the device itself; the rest is reported
/// by the loop.
struct TickFacts
{
  double time = 0.0; ///< s, given to the device
  DeviceSample sample;
  Vector3 sent = Vector3::Zero(); ///< N, device frame, given to the device

  std::uint32_t scene = 0;                ///< number of changes before
  double sceneShare = 1.0;                ///< share of that scene in the ideal force
  Vector3 tip = Vector3::Zero();          ///< mm, body frame, as all below
  Vector3 contactForce = Vector3::Zero(); ///< N, from that scene
  Vector3 idealForce = Vector3::Zero();   ///< N, from all scenes in contact
  Vector3 saidSent = Vector3::Zero();     ///< N, device frame, recorded as sent
  bool isPassivityLimited = false;        ///< the passivity control removed some of the force
};

/// Combines the record of the device and the report of the loop for the same tick.
TickFacts factsOf(double time, const DeviceSample& sample, const Vector3& sent, const Tick& tick);
} // namespace palpate::endurance

#endif
