// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Numerics/AvailableMemory.h"

#include <unistd.h>

#include <fstream>

namespace palpate
{
double availableMemory(const std::string& file)
{
  std::ifstream stream(file);
  std::string name;
  double kibibytes = 0.0;
  for (std::string rest; stream >> name >> kibibytes; std::getline(stream, rest))
  {
    if (name == "MemAvailable:")
    {
      return 1024.0 * kibibytes;
    }
  }
  return 0.5 * static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
    static_cast<double>(sysconf(_SC_PAGESIZE));
}
} // namespace palpate
