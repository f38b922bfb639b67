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
/// A body, a tool and what resists sliding: what can be felt at a time.
struct FeltScene
{
  std::shared_ptr<const RoundBody> body;
  ToolLaw tool{ ToolLaw::Flat, 1.0 };
  double friction = 0.0; ///< Coulomb's coefficient
  /// P, by which the instantaneous modulus of a body that relaxes exceeds the slow one; 0: elastic.
  double relaxation = 0.0;
  int elements = 16; ///< with which it is felt
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

/// One tick. What the device was asked for and given is from the device itself, the rest is what
/// the loop says it did.
struct TickFacts
{
  double time = 0.0; ///< s, the device was told
  DeviceSample sample;
  Vector3 sent = Vector3::Zero(); ///< N, device frame: what the device was given

  std::uint32_t scene = 0;                ///< how many changes came before
  double sceneShare = 1.0;                ///< of that scene in the ideal force
  Vector3 tip = Vector3::Zero();          ///< mm, body frame, as all below
  Vector3 contactForce = Vector3::Zero(); ///< N, of that scene
  Vector3 idealForce = Vector3::Zero();   ///< N, of all scenes felt
  Vector3 saidSent = Vector3::Zero();     ///< N, device frame: what was recorded as sent
  bool isPassivityLimited = false;        ///< the passivity control took some of the force
};

/// What the device saw beside what the loop says of the same tick.
TickFacts factsOf(double time, const DeviceSample& sample, const Vector3& sent, const Tick& tick);
} // namespace palpate::endurance

#endif
