// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_AvailableMemory_h
#define palpate_AvailableMemory_h

#include "Mechanics/PalpateExport.h"

#include <string>

namespace palpate
{
constexpr double Mebibyte = 1024.0 * 1024.0;

/// Returns the number of bytes that programs can still allocate on this machine without swapping:
/// `MemAvailable` of Linux (proc(5)). If the file has no such entry, returns half of the machine's
/// memory.
PALPATE_EXPORT double availableMemory(const std::string& file = "/proc/meminfo");
} // namespace palpate

#endif
