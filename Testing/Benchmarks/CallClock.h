// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_benchmarks_CallClock_h
#define palpate_benchmarks_CallClock_h

#include <chrono>
#include <cstdint>

#if defined(__x86_64__)
#include <x86intrin.h>
#endif

namespace palpate::benchmarks
{
/**
 * Times single calls of about ten nanoseconds. It reads the processor's time-stamp counter, with
 * fences so that all work of the call is measured. On processors other than x86-64 it uses the
 * steady clock. A reading does not access memory, so its cost is the same with cold caches. The
 * cost of an empty call is measured once and subtracted.
 */
class CallClock
{
public:
  /// Measures the length of a count and the cost of a reading; takes 0.1 s.
  CallClock();

  static std::uint64_t start() noexcept
  {
#if defined(__x86_64__)
    _mm_mfence();
    _mm_lfence();
    const std::uint64_t count = __rdtsc();
    _mm_lfence();
    return count;
#else
    return steadyCount();
#endif
  }

  static std::uint64_t stop() noexcept
  {
#if defined(__x86_64__)
    unsigned processor = 0;
    const std::uint64_t count = __rdtscp(&processor);
    _mm_lfence();
    return count;
#else
    return steadyCount();
#endif
  }

  /// Duration of a call that took `counts` counts, ns, without the cost of reading.
  double nanoseconds(std::uint64_t counts) const noexcept
  {
    return counts > this->Overhead
      ? static_cast<double>(counts - this->Overhead) * this->NanosecondsPerCount
      : 0.0;
  }
  /// Cost of a reading or the resolution of the clock, ns.
  double step() const noexcept
  {
    return static_cast<double>(this->Step) * this->NanosecondsPerCount;
  }
  double overhead() const noexcept
  {
    return static_cast<double>(this->Overhead) * this->NanosecondsPerCount;
  }

private:
  static std::uint64_t steadyCount() noexcept
  {
    return static_cast<std::uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count());
  }

  double NanosecondsPerCount;
  std::uint64_t Overhead;
  std::uint64_t Step;
};
} // namespace palpate::benchmarks

#endif
