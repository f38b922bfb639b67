// SPDX-License-Identifier: BSD-3-Clause
#include "ColdRead.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <random>
#include <vector>

#include <sys/mman.h>

namespace palpate::benchmarks
{
namespace
{
constexpr std::size_t Bytes = 64U << 20;

double medianRead(const CallClock& clock, CacheFlush& flush, int advice)
{
  void* const memory =
    mmap(nullptr, Bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED)
  {
    throw std::bad_alloc();
  }
  madvise(memory, Bytes, advice);
  std::memset(memory, 1, Bytes);
  const auto* const bytes = static_cast<const volatile unsigned char*>(memory);
  std::mt19937 random(7);
  std::uniform_int_distribution<std::size_t> anywhere(0, Bytes - 1);
  std::vector<double> times(201);
  for (double& time : times)
  {
    flush();
    const std::size_t at = anywhere(random);
    const std::uint64_t start = CallClock::start();
    static_cast<void>(bytes[at]);
    time = clock.nanoseconds(CallClock::stop() - start);
  }
  munmap(memory, Bytes);
  std::nth_element(times.begin(), times.begin() + 100, times.end());
  return times[100];
}
} // namespace

ColdRead measureColdRead(const CallClock& clock, CacheFlush& flush)
{
#ifdef MADV_HUGEPAGE
  return { medianRead(clock, flush, MADV_HUGEPAGE), medianRead(clock, flush, MADV_NOHUGEPAGE) };
#else
  const double read = medianRead(clock, flush, MADV_NORMAL);
  return { read, read };
#endif
}
} // namespace palpate::benchmarks
