// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_benchmarks_TickTimes_h
#define palpate_benchmarks_TickTimes_h

#include "CacheFlush.h"
#include "CallClock.h"
#include "TimedMethod.h"

#include <memory>
#include <string>
#include <vector>

namespace palpate::benchmarks
{
/// A method on one body, with the time and memory to build it.
struct Contender
{
  std::string name;
  std::unique_ptr<TimedMethod> method;
  double buildSeconds = 0.0;
  double megabytes = 0.0;
  int tipsPerCall = 1;
  const std::vector<Vector3>* tips = nullptr; ///< tips of all calls, in order
  TimedMethod* rehearsal = nullptr;           ///< the same method on another body, for warmCode
};

/// Statistics of single calls, ns.
struct CallTimes
{
  double median = 0.0;
  double p99 = 0.0;
  double p999 = 0.0;
  double mean = 0.0;
  double maximum = 0.0; ///< over all passes; includes interruptions by other work of the machine
  std::size_t calls = 0;
};

struct TickTimes
{
  CallTimes hot;
  CallTimes cold;
  CallTimes warmCode; ///< no calls without a rehearsal
};

/**
 * Hot: call after call along the path, repeated for `passes` passes. Only the fastest pass of each
 * call counts, because other work of the machine interrupts at random. Each pass begins with
 * flushed caches and some uncounted calls, so that data of new places come from memory, as under a
 * moving hand.
 * Cold: caches are flushed before every call, including body, code, stack and address translations.
 * The percentiles are over all calls.
 * Warm code: as cold, but after the flush the method has been called on another body, so that only
 * the body is cold.
 */
class TickTimer
{
public:
  static constexpr std::size_t UncountedCalls = 500;

  std::size_t hotCalls = 200000;
  std::size_t coldCalls = 2000;
  int passes = 3;
  /// Time limit of the hot calls, s. A slower method gets fewer than hotCalls calls, but at least
  /// 2000.
  double hotSeconds = 2.0;

  /**
   * Times the contenders of one body interleaved: pass by pass, call by call. Leaders are called
   * directly after a flush of the caches. Each follower is called after a leader with which it
   * shares no memory except the stack.
   */
  std::vector<TickTimes> run(std::vector<Contender>& contenders, std::size_t leaders);

  const CallClock& clock() const { return this->Clock; }
  CacheFlush& flush() { return this->Flush; }

private:
  std::size_t callsWithin(Contender& contender);
  void pass(Contender& contender, std::vector<double>& times);
  std::vector<std::vector<double>> cold(
    const std::vector<Contender>& contenders, std::size_t leaders);
  std::vector<double> warmCode(const Contender& contender);

  CallClock Clock;
  CacheFlush Flush;
};
} // namespace palpate::benchmarks

#endif
