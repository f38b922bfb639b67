// SPDX-License-Identifier: BSD-3-Clause
#include "TickTimes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace palpate::benchmarks
{
namespace
{
/// Returns the statistics. Sorts the times.
CallTimes summarise(std::vector<double>& times)
{
  std::sort(times.begin(), times.end());
  const auto at = [&](double share)
  {
    const double rank = std::ceil(share * static_cast<double>(times.size()));
    return times[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
  };
  CallTimes found;
  found.calls = times.size();
  found.median = at(0.5);
  found.p99 = at(0.99);
  found.p999 = at(0.999);
  found.maximum = times.back();
  found.mean = std::accumulate(times.begin(), times.end(), 0.0) / static_cast<double>(times.size());
  return found;
}

/// Returns the statistics over the fastest pass of each call.
CallTimes summariseFastest(const std::vector<std::vector<double>>& passes)
{
  std::vector<double> least = passes.front();
  double maximum = 0.0;
  for (const std::vector<double>& times : passes)
  {
    std::transform(times.begin(), times.end(), least.begin(), least.begin(),
      [](double a, double b) { return std::min(a, b); });
    maximum = std::max(maximum, *std::max_element(times.begin(), times.end()));
  }
  CallTimes found = summarise(least);
  found.maximum = maximum;
  return found;
}

std::size_t callsAlong(const Contender& contender)
{
  return contender.tips->size() / static_cast<std::size_t>(contender.tipsPerCall);
}

const Vector3* tipsOf(const Contender& contender, std::size_t call)
{
  const std::size_t onPath = call % callsAlong(contender);
  return contender.tips->data() + onPath * static_cast<std::size_t>(contender.tipsPerCall);
}
} // namespace

std::vector<TickTimes> TickTimer::run(std::vector<Contender>& contenders, std::size_t leaders)
{
  std::vector<std::vector<std::vector<double>>> hotTimes(contenders.size());
  for (std::size_t i = 0; i < contenders.size(); ++i)
  {
    const std::size_t calls = this->callsWithin(contenders[i]);
    hotTimes[i].assign(static_cast<std::size_t>(this->passes), std::vector<double>(calls));
  }
  for (std::size_t p = 0; p < static_cast<std::size_t>(this->passes); ++p)
  {
    for (std::size_t i = 0; i < contenders.size(); ++i)
    {
      this->pass(contenders[i], hotTimes[i][p]);
    }
  }
  std::vector<std::vector<double>> coldTimes = this->cold(contenders, leaders);
  std::vector<TickTimes> found(contenders.size());
  for (std::size_t i = 0; i < contenders.size(); ++i)
  {
    found[i].hot = summariseFastest(hotTimes[i]);
    found[i].cold = summarise(coldTimes[i]);
    if (contenders[i].rehearsal != nullptr)
    {
      std::vector<double> times = this->warmCode(contenders[i]);
      found[i].warmCode = summarise(times);
    }
  }
  return found;
}

std::size_t TickTimer::callsWithin(Contender& contender)
{
  constexpr std::size_t Least = 2000;
  contender.method->reset();
  double nanoseconds = 0.0;
  for (std::size_t call = 0; call < UncountedCalls; ++call)
  {
    nanoseconds += this->Clock.nanoseconds(contender.method->time(tipsOf(contender, call)));
  }
  const double each = std::max(1.0, nanoseconds / UncountedCalls);
  const double within = 1e9 * this->hotSeconds / (each * this->passes);
  const std::size_t enough = std::max(Least, static_cast<std::size_t>(within));
  return std::min({ enough, this->hotCalls, callsAlong(contender) - UncountedCalls });
}

void TickTimer::pass(Contender& contender, std::vector<double>& times)
{
  TimedMethod& method = *contender.method;
  this->Flush();
  method.reset();
  std::size_t call = 0;
  for (; call < UncountedCalls; ++call)
  {
    method.time(tipsOf(contender, call));
  }
  for (double& time : times)
  {
    time = this->Clock.nanoseconds(method.time(tipsOf(contender, call++)));
  }
}

std::vector<std::vector<double>> TickTimer::cold(
  const std::vector<Contender>& contenders, std::size_t leaders)
{
  std::vector<std::vector<double>> times(
    contenders.size(), std::vector<double>(this->coldCalls, 0.0));
  for (const Contender& contender : contenders)
  {
    contender.method->reset();
    contender.method->time(tipsOf(contender, 0));
  }
  const auto timeOne = [&](std::size_t i, std::size_t call)
  {
    const Contender& contender = contenders[i];
    times[i][call] = this->Clock.nanoseconds(contender.method->time(tipsOf(contender, call + 1)));
  };
  for (std::size_t call = 0; call < this->coldCalls; ++call)
  {
    for (std::size_t leader = 0; leader < leaders; ++leader)
    {
      this->Flush();
      timeOne(leader, call);
      for (std::size_t i = leaders + leader; i < contenders.size(); i += leaders)
      {
        timeOne(i, call);
      }
    }
  }
  return times;
}

std::vector<double> TickTimer::warmCode(const Contender& contender)
{
  std::vector<double> times(this->coldCalls / 4 + 1);
  contender.method->reset();
  contender.method->time(tipsOf(contender, 0));
  std::size_t call = 1;
  for (double& time : times)
  {
    const Vector3* const tips = tipsOf(contender, call++);
    this->Flush();
    contender.rehearsal->time(tips);
    time = this->Clock.nanoseconds(contender.method->time(tips));
  }
  return times;
}
} // namespace palpate::benchmarks
