// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/PressHistory.h"

#include "Identification/ArrangedReadings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace palpate
{
namespace
{
constexpr std::size_t ManyReadings = 600; // number of readings above which readings are averaged
constexpr double DepthShare = 0.005;      // fraction of the range over which readings are averaged
// Fraction of the time since the last turning point over which readings are averaged.
constexpr double TimeShare = 0.03;
// Fraction of the range. Between two points that are farther apart, points are inserted.
constexpr double StepShare = 0.02;
// Shortest resolved relaxation time, as a fraction of the time of a press.
constexpr double RampShare = 1.0 / 15.0;
// Uncertainty of the estimated depth of first contact, as a fraction of the depth.
constexpr double ContactShare = 0.1;
constexpr double LittleShare = 0.02; // a reversal by less than this fraction of the depth is noise

/// Returns the index of the first reading of each group, and finally the number of readings.
std::vector<std::size_t> groupsOf(
  const MeasuredCurve& curve, const std::vector<std::size_t>& turns, double range, double slack)
{
  std::vector<std::size_t> starts;
  std::size_t turn = 0;
  for (std::size_t i = 0; i < curve.time.size();)
  {
    starts.push_back(i);
    const bool turnsHere = std::binary_search(turns.begin(), turns.end(), i);
    turn = turnsHere ? i : turn;
    const double since = curve.time[i] - curve.time[turn];
    std::size_t next = i + 1;
    while (!turnsHere && next < curve.time.size() &&
      !std::binary_search(turns.begin(), turns.end(), next) &&
      std::abs(curve.deflection[next] - curve.deflection[i]) <= slack * DepthShare * range &&
      curve.time[next] - curve.time[i] <= slack * TimeShare * since)
    {
      ++next;
    }
    i = next;
  }
  starts.push_back(curve.time.size());
  return starts;
}

/// Returns the smallest time between two points with readings, s.
double closestReadings(const PressHistory& history)
{
  double closest = std::numeric_limits<double>::infinity();
  double before = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < history.size(); ++i)
  {
    if (history.readings[i] > 0.0)
    {
      closest = history.time[i] > before ? std::min(closest, history.time[i] - before) : closest;
      before = history.time[i];
    }
  }
  return closest;
}

void append(PressHistory& history, double time, double deflection, double force, double readings)
{
  history.time.push_back(time);
  history.deflection.push_back(deflection);
  history.force.push_back(force);
  history.readings.push_back(readings);
}
} // namespace

PressHistory makeHistory(const AxisymmetricTool& tool, const MeasuredCurve& curve,
  const PreparedCurve& prepared, bool findContact)
{
  PressHistory history;
  history.tool = &tool;
  history.loading = arrangeReadings(loadsByDepth(tool, prepared), findContact);
  history.noise = estimateForceNoise(curve.time, curve.force);
  const double contact = history.loading.start.depth;
  const double range =
    *std::max_element(curve.deflection.begin(), curve.deflection.end()) - contact;
  std::vector<std::size_t> starts(curve.time.size() + 1);
  std::iota(starts.begin(), starts.end(), std::size_t{ 0 });
  for (double slack = 1.0;
       starts.size() > 2 * ManyReadings || (slack == 1.0 && starts.size() > ManyReadings + 1);
       slack *= 1.5)
  {
    starts = groupsOf(curve, prepared.turns, range, slack);
    if (slack > 1e6) // the loop ends: there are nearly as many turning points as readings
    {
      break;
    }
  }
  for (std::size_t g = 0; g + 1 < starts.size(); ++g)
  {
    const auto mean = [&](const std::vector<double>& values)
    {
      const auto first = values.begin();
      return std::accumulate(first + static_cast<std::ptrdiff_t>(starts[g]),
               first + static_cast<std::ptrdiff_t>(starts[g + 1]), 0.0) /
        static_cast<double>(starts[g + 1] - starts[g]);
    };
    const double time = mean(curve.time);
    const double deflection = mean(curve.deflection);
    // Inserts points between the points with readings. Before contact no inserted points are
    // needed.
    if (g > 0 && std::max(deflection, history.deflection.back()) > contact - ContactShare * range)
    {
      const double lastTime = history.time.back();
      const double last = history.deflection.back();
      const int steps =
        static_cast<int>(std::ceil(std::abs(deflection - last) / (StepShare * range)));
      for (int k = 1; k < steps; ++k)
      {
        const double share = static_cast<double>(k) / steps;
        append(history, lastTime + share * (time - lastTime), last + share * (deflection - last),
          0.0, 0.0);
      }
    }
    append(
      history, time, deflection, mean(curve.force), static_cast<double>(starts[g + 1] - starts[g]));
  }
  return history;
}

TimeWindow windowOf(const std::vector<PressHistory>& histories, const std::vector<double>& offsets)
{
  TimeWindow window{ std::numeric_limits<double>::infinity(), 0.0 };
  for (std::size_t c = 0; c < histories.size(); ++c)
  {
    const PressHistory& history = histories[c];
    const std::vector<double>& deflection = history.deflection;
    const double most = *std::max_element(deflection.begin(), deflection.end());
    const double little = LittleShare * (most - offsets[c]);
    const double closest = closestReadings(history);
    for (std::size_t i = 0; i < history.size();)
    {
      if (!(deflection[i] - offsets[c] > little))
      {
        ++i;
        continue;
      }
      std::size_t end = i; // index after the last point of this press
      // Largest depth of a point with a reading.
      double deepest = -std::numeric_limits<double>::infinity();
      for (; end < history.size() && deflection[end] - offsets[c] > little; ++end)
      {
        deepest = history.readings[end] > 0.0 ? std::max(deepest, deflection[end]) : deepest;
      }
      const double began = history.time[i > 0 ? i - 1 : 0];
      double arrived = began;
      const bool isCompared = deepest > offsets[c];
      for (std::size_t k = end; k-- > i;)
      {
        if (deflection[k] >= deepest - little && history.readings[k] > 0.0)
        {
          window.longest = std::max(window.longest, history.time[k] - began);
          arrived = history.time[k];
        }
      }
      window.shortest = !isCompared
        ? window.shortest
        : std::min(window.shortest, std::max(RampShare * (arrived - began), closest));
      i = end;
    }
  }
  window.shortest = std::min(window.shortest, window.longest);
  return window;
}
} // namespace palpate
