// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Simulation/DeviceFaults.h"

#include <cmath>

namespace palpate
{
namespace
{
constexpr std::array<const char*, DeviceFaultCount> Names = { "NotANumber", "Repeated", "Dropped",
  "Late", "Stall", "Disconnect" };
}

std::string fault(const DeviceFaults& faults)
{
  for (std::size_t i = 0; i < faults.schedule.size(); ++i)
  {
    const ScheduledFault& scheduled = faults.schedule[i];
    const std::string place = "scheduled fault " + std::to_string(i);
    if (static_cast<std::size_t>(scheduled.fault) >= DeviceFaultCount)
    {
      return place + " is of no known kind";
    }
    if (!std::isfinite(scheduled.start))
    {
      return place + " has a start that is not finite";
    }
    if (!(scheduled.duration >= 0.0))
    {
      return place + " has a duration that is negative or not a number";
    }
  }
  for (std::size_t i = 0; i < DeviceFaultCount; ++i)
  {
    const FaultRate& rate = faults.rates[i];
    if (!(rate.probability >= 0.0 && rate.probability <= 1.0))
    {
      return std::string("the probability of ") + Names[i] + " must be from 0 to 1";
    }
    if (!(rate.duration >= 0.0))
    {
      return std::string("the duration of ") + Names[i] + " must not be negative";
    }
  }
  return {};
}
} // namespace palpate
