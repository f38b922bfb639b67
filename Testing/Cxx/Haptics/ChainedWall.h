// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_ChainedWall_h
#define palpate_testing_ChainedWall_h

#include "Haptics/Safety/SafetyChain.h"

#include <algorithm>
#include <cstdint>

namespace palpate::testing
{
constexpr double Period = 1e-3; // s

/// A wall of 1000 N/m below z = 0 that is pressed along z, with the safety chain and the time.
struct ChainedWall
{
  explicit ChainedWall(const SafetySettings& settings)
    : Chain(settings)
  {
  }

  SafetyInput at(double depth)
  {
    SafetyInput input;
    input.time = this->Time;
    this->Time += Period;
    input.valid = true;
    input.position.z() = -depth;
    input.outside = depth <= 0.0;
    input.idealForce.z() = std::max(0.0, 1000.0 * depth);
    input.cappedForce = input.idealForce;
    input.depth = std::max(0.0, depth);
    return input;
  }
  SafeForce feel(double depth) { return this->Chain.apply(this->at(depth)); }
  /// Presses from outside to a depth of 4 mm, where the force is 4 N.
  SafeForce press()
  {
    SafeForce last;
    for (int i = -10; i <= 40; ++i)
    {
      last = this->feel(1e-4 * i);
    }
    return last;
  }

  SafetyChain Chain;
  double Time = 10.0;
};

inline SafetySettings whole()
{
  DeviceSpecification device;
  device.maximumForceRate = 5000.0; // 5 N per ms
  device.maximumStiffness = 3000.0;
  return SafetySettings::of(device);
}

inline std::uint16_t flag(SafetyLink link)
{
  return static_cast<std::uint16_t>(link);
}
} // namespace palpate::testing

#endif
