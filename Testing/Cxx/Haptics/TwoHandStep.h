// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_TwoHandStep_h
#define palpate_testing_TwoHandStep_h

#include "CoupledPlate.h"
#include "Haptics/Servo/ServoStep.h"
#include "Mechanics/Numerics/Constants.h"

#include <array>
#include <cmath>

namespace palpate::testing
{
using TwoSamples = std::array<DeviceSample, 2>;

/// A step of two hands that stores its newest ticks.
struct TwoHandStep : ServoStep
{
  using ServoStep::ServoStep;
  const std::array<Tick, 2>& press(const TwoSamples& samples, double time)
  {
    this->step(samples.data(), time, this->ticks.data());
    return this->ticks;
  }
  std::array<Tick, 2> ticks;
};

inline DeviceSample sampleOf(const WorkspaceMapping& mapping, const Vector3& tip)
{
  DeviceSample sample;
  sample.position = mapping.toDevice(tip);
  sample.valid = true;
  return sample;
}

/// Two flat ends on the CoupledPlate.
struct FlatEnds
{
  static constexpr double Spring = 2.0 * CoupledPlate::Flat; ///< N/mm, for a modulus of 1 MPa
  static constexpr double Apart = 5.0;                       ///< mm
  static constexpr double Mutual = 1.0 / (Pi * Apart);       ///< C_12 of Boussinesq, mm/N

  /// Force of the first of two linear springs, each of which lowers the surface under the other.
  static double force(double own, double other)
  {
    return Spring * (own - Mutual * Spring * other) / (1.0 - std::pow(Mutual * Spring, 2));
  }
  /// Samples of two hands at these depths below z = 0, mm.
  static TwoSamples pressing(double first, double second)
  {
    return { sampleOf({}, { 25.0, 29.3, -first }), sampleOf({}, { 25.0 + Apart, 29.3, -second }) };
  }
};
} // namespace palpate::testing

#endif
