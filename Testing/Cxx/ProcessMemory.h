// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_ProcessMemory_h
#define palpate_testing_ProcessMemory_h

#include <fstream>
#include <limits>
#include <string>

namespace palpate::testing
{
/// Memory of this process from a line of /proc/self/status (proc(5)), bytes. NaN if the system does
/// not report it, so that no comparison with a limit holds.
inline double statusMemory(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  const std::string label = name + ":";
  std::string line;
  while (std::getline(status, line))
  {
    if (line.rfind(label, 0) == 0)
    {
      return 1024.0 * std::stod(line.substr(label.size()));
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// Bytes resident now, including memory that was freed but not returned (malloc_trim).
inline double residentMemory()
{
  return statusMemory("VmRSS");
}

/// Largest number of resident bytes since the process began or since resetPeakMemory.
inline double peakMemory()
{
  return statusMemory("VmHWM");
}

inline void resetPeakMemory()
{
  std::ofstream("/proc/self/clear_refs") << "5"; // sets the peak to the memory resident now
}

/// Bytes locked by mlockall or mlock.
inline double lockedMemory()
{
  return statusMemory("VmLck");
}
} // namespace palpate::testing

#endif
