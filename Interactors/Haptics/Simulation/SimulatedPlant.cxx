// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Simulation/SimulatedPlant.h"

#include <cstddef>
#include <limits>
#include <sstream>

namespace palpate
{
namespace
{
constexpr double LeastMass = 1e-6;   // kg
constexpr double Most = 1e9;         // beyond any device, and squares of it do not overflow
constexpr double LongestDelay = 1.0; // s

struct Setting
{
  const char* name;
  double value;
  double least;
  double most;
};

/// NaN is outside any bounds.
template <std::size_t Count>
std::string outside(const Setting (&settings)[Count])
{
  for (const Setting& setting : settings)
  {
    if (!(setting.value >= setting.least && setting.value <= setting.most))
    {
      std::ostringstream text;
      text << setting.name << " must be from " << setting.least << " to " << setting.most
           << ", not " << setting.value;
      return text.str();
    }
  }
  return {};
}

} // namespace

std::string fault(const SimulatedPlant& plant)
{
  return outside({ { "mass", plant.mass, LeastMass, Most }, { "damping", plant.damping, 0.0, Most },
    { "friction", plant.friction, 0.0, Most }, { "encoderStep", plant.encoderStep, 0.0, Most },
    { "forceDelay", plant.forceDelay, 0.0, LongestDelay },
    { "sampleDelay", plant.sampleDelay, 0.0, LongestDelay } });
}

std::string fault(const HandModel& hand)
{
  return outside({ { "hand's stiffness", hand.stiffness, 0.0, Most },
    { "hand's damping", hand.damping, 0.0, Most },
    { "hand's maximumForce", hand.maximumForce, 0.0, std::numeric_limits<double>::infinity() } });
}
} // namespace palpate
