// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_benchmarks_ColdRead_h
#define palpate_benchmarks_ColdRead_h

#include "CacheFlush.h"
#include "CallClock.h"

namespace palpate::benchmarks
{
/// What one read of a line costs that is in no cache, median, ns: the yardstick of this machine, at
/// this hour, for a cold tick. In 64 MiB of pages of 2 MiB, if the system grants them, and of 4
/// KiB.
struct ColdRead
{
  double largePages;
  double smallPages;
};
ColdRead measureColdRead(const CallClock& clock, CacheFlush& flush);
} // namespace palpate::benchmarks

#endif
