// SPDX-License-Identifier: BSD-3-Clause
#include "MethodTimer.h"

#include <algorithm>
#include <array>
#include <limits>

namespace palpate::testing
{
namespace
{
using benchmarks::CallClock;

constexpr std::size_t Uncounted = 50; // calls at the start of a pass
constexpr std::size_t Least = 3;      // calls of a method that takes seconds

double median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}
} // namespace

/// Time of one call, ns. forget() is not counted.
double MethodTimer::call(ContactMethod& method, const StudyTip& tip) const
{
  if (tip.isNew)
  {
    method.forget();
  }
  const std::uint64_t start = CallClock::start();
  const volatile double felt = method.force(tip.position).z();
  static_cast<void>(felt);
  return this->Clock.nanoseconds(CallClock::stop() - start);
}

/// Time of one call along the path, s: the median of three.
double MethodTimer::estimate(ContactMethod& method, const StudyTips& tips) const
{
  method.forget();
  std::array<double, 3> each{};
  for (std::size_t i = 0; i < each.size(); ++i)
  {
    each[i] = this->call(method, tips.path[i]);
  }
  std::sort(each.begin(), each.end());
  return 1e-9 * each[1];
}

void MethodTimer::timeHot(const MethodList& methods, const std::vector<StudyTip>& tips,
  const std::vector<std::size_t>& counts, double MethodTimes::*what,
  std::vector<MethodTimes>& times) const
{
  std::vector<std::vector<double>> fastest;
  for (const std::size_t count : counts)
  {
    fastest.emplace_back(count, std::numeric_limits<double>::infinity());
  }
  for (int pass = 0; pass < this->passes; ++pass)
  {
    for (std::size_t m = 0; m < methods.size(); ++m)
    {
      const bool isSlow = counts[m] == Least;
      if (isSlow && pass > 0)
      {
        continue;
      }
      methods[m].method->forget();
      const std::size_t skipped = isSlow ? 0 : std::min(Uncounted, tips.size() - counts[m]);
      for (std::size_t i = 0; i < skipped; ++i)
      {
        this->call(*methods[m].method, tips[i]);
      }
      for (std::size_t i = 0; i < counts[m]; ++i)
      {
        double& least = fastest[m][i];
        least = std::min(least, this->call(*methods[m].method, tips[skipped + i]));
      }
    }
  }
  for (std::size_t m = 0; m < methods.size(); ++m)
  {
    times[m].*what = median(fastest[m]);
  }
}

std::vector<MethodTimes> MethodTimer::run(const MethodList& methods, const StudyTips& tips)
{
  std::vector<MethodTimes> times(methods.size());
  std::vector<double> estimates;
  const auto counts = [&](std::size_t most, int passesOver)
  {
    std::vector<std::size_t> found;
    for (const double each : estimates)
    {
      const double within = this->seconds / (each * passesOver + 1e-9);
      found.push_back(std::clamp(static_cast<std::size_t>(std::min(within, 1e9)), Least, most));
    }
    return found;
  };
  for (const StudyMethod& each : methods)
  {
    estimates.push_back(this->estimate(*each.method, tips));
  }
  this->timeHot(methods, tips.path, counts(std::min(this->calls, tips.path.size()), this->passes),
    &MethodTimes::hot, times);
  this->timeHot(methods, tips.sites, counts(std::min(this->calls, tips.sites.size()), this->passes),
    &MethodTimes::onset, times);
  std::vector<std::vector<double>> cold(methods.size());
  const std::vector<std::size_t> most = counts(std::min(this->coldCalls, tips.path.size()), 1);
  for (std::size_t i = 0; i < this->coldCalls; ++i)
  {
    for (std::size_t m = 0; m < methods.size(); ++m)
    {
      if (i < most[m])
      {
        this->Flush();
        cold[m].push_back(this->call(*methods[m].method, tips.path[i]));
      }
    }
  }
  for (std::size_t m = 0; m < methods.size(); ++m)
  {
    times[m].cold = median(cold[m]);
  }
  return times;
}
} // namespace palpate::testing
