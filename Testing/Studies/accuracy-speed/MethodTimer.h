// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CacheFlush.h"
#include "CallClock.h"
#include "StudyScene.h"

#include <cstddef>
#include <vector>

namespace palpate::testing
{
/// Medians of single calls, ns.
struct MethodTimes
{
  double hot = 0.0;   ///< tick after tick along the path
  double onset = 0.0; ///< at the random sites, each a new contact
  double cold = 0.0;  ///< along the path, caches flushed before each call
};

/**
 * Times several methods, which take turns on the same tips. Hot and onset times: several passes
 * over the tips. The fastest pass of each call counts, because other work of the machine
 * interrupts at random. Cold times: the methods take turns call by call.
 */
class MethodTimer
{
public:
  int passes = 5;
  std::size_t calls = 2000;
  std::size_t coldCalls = 21;
  double seconds = 0.5; ///< per method for each of the three; a slow method gets fewer calls

  std::vector<MethodTimes> run(const MethodList& methods, const StudyTips& tips);

  const benchmarks::CallClock& clock() const { return this->Clock; }
  benchmarks::CacheFlush& flush() { return this->Flush; }

private:
  double call(ContactMethod& method, const StudyTip& tip) const;
  double estimate(ContactMethod& method, const StudyTips& tips) const;
  void timeHot(const MethodList& methods, const std::vector<StudyTip>& tips,
    const std::vector<std::size_t>& counts, double MethodTimes::*what,
    std::vector<MethodTimes>& times) const;

  benchmarks::CallClock Clock;
  benchmarks::CacheFlush Flush;
};
} // namespace palpate::testing
