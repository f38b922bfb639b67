// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_benchmarks_ColdRead_h
#define palpate_benchmarks_ColdRead_h

#include "CacheFlush.h"
#include "CallClock.h"

namespace palpate::benchmarks
{
/// Median time of one read of a cache line that is in no cache, ns. It is the reference for a cold
/// tick on this machine at this time. Measured in 64 MiB of memory, in pages of 2 MiB if the system
/// provides them, and in pages of 4 KiB.
struct ColdRead
{
  double largePages;
  double smallPages;
};
ColdRead measureColdRead(const CallClock& clock, CacheFlush& flush);
} // namespace palpate::benchmarks

#endif
