// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_ProcessMemory_h
#define palpate_testing_ProcessMemory_h

#include <fstream>
#include <limits>
#include <string>

namespace palpate::testing
{
/// Memory of this process from a line of /proc/self/status (proc(5)), bytes; NaN where the system
/// does not tell, so that no comparison with a limit holds.
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

/// Bytes resident now; with what was freed and not given back (malloc_trim).
inline double residentMemory()
{
  return statusMemory("VmRSS");
}

/// The most bytes that were resident since the process began, or since resetPeakMemory.
inline double peakMemory()
{
  return statusMemory("VmHWM");
}

inline void resetPeakMemory()
{
  std::ofstream("/proc/self/clear_refs") << "5"; // the mark is what is resident now
}

/// Bytes that mlockall or mlock keeps.
inline double lockedMemory()
{
  return statusMemory("VmLck");
}
} // namespace palpate::testing

#endif
