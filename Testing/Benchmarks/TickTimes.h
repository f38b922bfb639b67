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
/// A method on one body, with what it cost to build.
struct Contender
{
  std::string name;
  std::unique_ptr<TimedMethod> method;
  double buildSeconds = 0.0;
  double megabytes = 0.0;
  int tipsPerCall = 1;
  const std::vector<Vector3>* tips = nullptr; ///< of all its calls, one after the other
  TimedMethod* rehearsal = nullptr;           ///< the same method on another body, for warmCode
};

/// Of single calls, ns.
struct CallTimes
{
  double median = 0.0;
  double p99 = 0.0;
  double p999 = 0.0;
  double mean = 0.0;
  double maximum = 0.0; ///< of all passes, also what the machine did in between
  std::size_t calls = 0;
};

struct TickTimes
{
  CallTimes hot;
  CallTimes cold;
  CallTimes warmCode; ///< no calls without a rehearsal
};

/**
 * Hot: call after call along the path, `passes` times over; of each call the fastest pass counts,
 * because what else the machine does comes at random. Each pass begins with flushed caches and some
 * calls that do not count, so that new ground comes from memory, as under a hand.
 *
 * Cold: caches flushed before every call, of body, code, stack and translations of addresses;
 * percentiles as they come. Warm code: the same, but the method was called on another body since
 * the flush, so that only the body is cold.
 */
class TickTimer
{
public:
  static constexpr std::size_t UncountedCalls = 500;

  std::size_t hotCalls = 200000;
  std::size_t coldCalls = 2000;
  int passes = 3;
  /// A method gets fewer hot calls than hotCalls if they took longer than this, s; 2000 at least.
  double hotSeconds = 2.0;

  /**
   * Times the contenders of one body interleaved: pass by pass, call by call. Leaders are called
   * straight after a flush of the caches; each follower after one of the leaders, of whose memory
   * it shares nothing but the stack.
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
