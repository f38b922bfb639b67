// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_DeviceSupply_h
#define palpate_endurance_DeviceSupply_h

#include "TickFacts.h"
#include "UnsteadyDevice.h"

#include <cstdint>
#include <memory>
#include <random>
#include <vector>

namespace palpate::endurance
{
/**
 * Supplies devices in turn: a stiff hand, a mass in a compliant hand, and a recorded trajectory.
 * Each device lasts some seconds and has its own faults (FaultyDevice). All devices press
 * repeatedly on a nearly round body while they move around it.
 */
class DeviceSupply
{
public:
  DeviceSupply(const DeviceFrame& frame, const DeviceSpecification& specification,
    const Vector3& centre, double radius, unsigned seed);

  std::unique_ptr<PluggedDevice> make();

private:
  struct Place
  {
    double time;
    Vector3 tip;
  };
  std::vector<Place> makePath(double seconds);
  std::unique_ptr<HapticDevice> makeHand(double seconds);
  double between(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Random);
  }

  DeviceFrame Frame;
  DeviceSpecification Specification;
  Vector3 Centre;
  double Radius;
  std::mt19937 Random;
  std::uint64_t Made = 0;
};
} // namespace palpate::endurance

#endif
