// SPDX-License-Identifier: BSD-3-Clause
#include "ManyCores.h"

#include <sys/sysinfo.h>
#include <unistd.h>

namespace
{
int cores = 0;
}

/// Replaces the function of the C library that std::thread::hardware_concurrency() calls.
extern "C" __attribute__((visibility("default"))) int get_nprocs() noexcept
{
  return cores > 0 ? cores : static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN));
}

namespace palpate::testing
{
ManyCores::ManyCores(int count)
{
  cores = count;
}

ManyCores::~ManyCores()
{
  cores = 0;
}
} // namespace palpate::testing
