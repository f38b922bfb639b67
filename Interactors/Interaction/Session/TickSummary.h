// SPDX-License-Identifier: BSD-3-Clause
#ifndef TickSummary_h
#define TickSummary_h

#include "Haptics/Servo/ServoStep.h"

#include <algorithm>
#include <cstdint>

namespace palpate
{
/// What is kept of ticks that are not.
struct TickSummary
{
  std::uint64_t ticks = 0;
  std::uint64_t inContact = 0;
  double peakForce = 0.0;      ///< ideal, N
  double peakApplied = 0.0;    ///< N
  double peakFriction = 0.0;   ///< N
  double peakDeflection = 0.0; ///< mm
  std::uint16_t acted = 0;     ///< every SafetyLink that acted in any of them

  void add(const Tick& tick)
  {
    this->ticks += 1;
    this->inContact += tick.contact.triangle >= 0 ? 1 : 0;
    this->peakForce = std::max(this->peakForce, tick.contact.force.norm());
    this->peakApplied = std::max(this->peakApplied, tick.appliedForce.norm());
    this->peakFriction = std::max(this->peakFriction, tick.contact.friction.norm());
    this->peakDeflection = std::max(this->peakDeflection, tick.contact.deflection);
    this->acted = static_cast<std::uint16_t>(this->acted | tick.acted);
  }
};
} // namespace palpate

#endif
