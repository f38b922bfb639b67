// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Safety/SafetyText.h"

#include "Haptics/Safety/SafetyChain.h"

#include <iomanip>
#include <sstream>
#include <utility>

namespace palpate
{
namespace
{
constexpr std::pair<SafetyLink, const char*> Words[] = {
  { SafetyLink::NotFinite, "no force: it was not finite" },
  { SafetyLink::Gate, "held back until the tip has been outside" },
  { SafetyLink::Fit, nullptr }, // described by the factor
  { SafetyLink::StiffnessCap, "stiffness capped" },
  { SafetyLink::Slew, "rise limited" },
  { SafetyLink::Magnitude, "limited to the device's largest force" },
  { SafetyLink::Passivity, "damped against energy from nothing" },
  { SafetyLink::Watchdog, "no force: the device is silent" },
  { SafetyLink::NoSample, "no force: the device reports no position" },
  { SafetyLink::Stopped, "no force: stopped" },
};
} // namespace

std::string describeForceFactor(double forceFactor)
{
  std::ostringstream text;
  text << "force \u00d7" << std::setprecision(2) << forceFactor;
  return text.str();
}

std::string describeSafety(std::uint16_t acted, double forceFactor, const std::string& fitReason)
{
  const std::string fit =
    describeForceFactor(forceFactor) + (fitReason.empty() ? "" : " (" + fitReason + ")");
  std::string text;
  for (const auto& [link, words] : Words)
  {
    if ((acted & static_cast<std::uint16_t>(link)) != 0)
    {
      text += text.empty() ? "" : ", ";
      text += words != nullptr ? words : fit;
    }
  }
  return text;
}
} // namespace palpate
