// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/CurvePreparation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <numeric>

namespace palpate
{
namespace
{
// Smallest reversal of the deflection that ends a branch, as a fraction of the range. A smaller
// reversal is noise.
constexpr double TurnShare = 0.1;
// Fraction of the range. Readings within this distance of a turning point are at rest.
constexpr double RestShare = 0.01;
// Fraction of the range. A hold may begin within this distance before the end of a loading.
constexpr double NearlyShare = 0.03;
// Two loadings whose speed ratio is smaller count as equally fast.
constexpr double SpeedRatio = 1.5;

/// The readings from `first` to `last` (inclusive), which belong to one phase.
struct Segment
{
  CurvePhase phase = CurvePhase::Unknown;
  std::size_t first = 0;
  std::size_t last = 0;
};

std::vector<Segment> recordedSegments(const std::vector<CurvePhase>& phases)
{
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < phases.size(); ++i)
  {
    if (segments.empty() || segments.back().phase != phases[i])
    {
      segments.push_back({ phases[i], i, i });
    }
    segments.back().last = i;
  }
  return segments;
}

/// Returns the first reading, the turning points, each at least `step` (mm) from the preceding one,
/// and the last reading.
std::vector<std::size_t> turningPoints(const std::vector<double>& deflection, double step)
{
  std::vector<std::size_t> turns = { 0 };
  std::size_t low = 0;
  std::size_t high = 0;
  int direction = 0; // +1 if rising, -1 if falling, 0 if unknown
  for (std::size_t i = 1; i < deflection.size(); ++i)
  {
    low = deflection[i] < deflection[low] ? i : low;
    high = deflection[i] > deflection[high] ? i : high;
    if (direction >= 0 && deflection[i] < deflection[high] - step)
    {
      turns.push_back(high);
      direction = -1;
      low = i;
    }
    else if (direction <= 0 && deflection[i] > deflection[low] + step)
    {
      turns.push_back(low);
      direction = 1;
      high = i;
    }
  }
  turns.push_back(deflection.size() - 1);
  turns.erase(std::unique(turns.begin(), turns.end()), turns.end());
  return turns;
}

std::vector<Segment> foundSegments(const std::vector<double>& deflection, double range)
{
  std::vector<Segment> segments;
  const std::vector<std::size_t> turns = turningPoints(deflection, TurnShare * range);
  for (std::size_t i = 1; i < turns.size(); ++i)
  {
    const double rise = deflection[turns[i]] - deflection[turns[i - 1]];
    if (std::abs(rise) < TurnShare * range)
    {
      continue;
    }
    const bool rises = rise > 0.0;
    Segment segment{ rises ? CurvePhase::Loading : CurvePhase::Unloading, turns[i - 1], turns[i] };
    // A branch begins with the last reading at rest at its first turning point, and ends with the
    // first reading at rest at its second turning point.
    const auto rests = [&](std::size_t reading, std::size_t turn)
    { return std::abs(deflection[reading] - deflection[turn]) <= RestShare * range; };
    if (i > 1)
    {
      while (segment.first < segment.last && rests(segment.first + 1, turns[i - 1]))
      {
        ++segment.first;
      }
    }
    while (segment.last > segment.first + 1 && rests(segment.last - 1, turns[i]))
    {
      --segment.last;
    }
    segments.push_back(segment);
  }
  return segments;
}

/// Returns ∫ F dδ from `low` to `high` of a branch, N mm, by the trapezoidal rule. The result is
/// positive in either direction.
double energy(const std::vector<double>& deflection, const std::vector<double>& force,
  const Segment& branch, double low, double high)
{
  double sum = 0.0;
  for (std::size_t i = branch.first; i < branch.last; ++i)
  {
    const double a = deflection[i];
    const double b = deflection[i + 1];
    const double from = std::clamp(a, low, high);
    const double to = std::clamp(b, low, high);
    if (from != to)
    {
      const auto at = [&](double x)
      { return force[i] + (force[i + 1] - force[i]) * (x - a) / (b - a); };
      sum += 0.5 * (at(from) + at(to)) * (to - from);
    }
  }
  return std::abs(sum);
}

struct Span
{
  double low;
  double high;
};

Span spanOf(const std::vector<double>& deflection, const Segment& branch)
{
  const auto first = deflection.begin() + static_cast<std::ptrdiff_t>(branch.first);
  const auto last = deflection.begin() + static_cast<std::ptrdiff_t>(branch.last) + 1;
  const auto extremes = std::minmax_element(first, last);
  return { *extremes.first, *extremes.second };
}

Span common(Span a, Span b)
{
  return { std::max(a.low, b.low), std::min(a.high, b.high) };
}

double hysteresisOf(const MeasuredCurve& curve, const Segment& loading, const Segment& unloading)
{
  const Span both = common(spanOf(curve.deflection, loading), spanOf(curve.deflection, unloading));
  const double in = energy(curve.deflection, curve.force, loading, both.low, both.high);
  const double out = energy(curve.deflection, curve.force, unloading, both.low, both.high);
  return in > 0.0 ? 1.0 - out / in : std::numeric_limits<double>::quiet_NaN();
}

/// Returns the relative decrease of the force between two readings at constant depth.
double lossOf(const MeasuredCurve& curve, std::size_t first, std::size_t last)
{
  constexpr std::size_t fewest = 5;
  if (last < first + fewest)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const std::size_t count = last - first + 1;
  const auto mean = [&](std::size_t from, std::size_t n)
  {
    const auto begin = curve.force.begin() + static_cast<std::ptrdiff_t>(from);
    return std::accumulate(begin, begin + static_cast<std::ptrdiff_t>(n), 0.0) /
      static_cast<double>(n);
  };
  const std::size_t few = 1 + count / 50;
  double most = 0.0; // largest mean; the depth may still increase slightly at the beginning
  for (std::size_t i = first; i + few <= first + count / 2 + 1; ++i)
  {
    most = std::max(most, mean(i, few));
  }
  const std::size_t end = 1 + count / 10;
  return most > 0.0 ? 1.0 - mean(last + 1 - end, end) / most
                    : std::numeric_limits<double>::quiet_NaN();
}

/// Computes the largest relative decrease of the force in holds at the end of a loading, and the
/// ends of all segments.
void judgeHolds(const MeasuredCurve& curve, const std::vector<Segment>& segments, double range,
  PreparedCurve& prepared)
{
  for (std::size_t s = 0; s < segments.size(); ++s)
  {
    const Segment& segment = segments[s];
    prepared.turns.push_back(segment.first);
    prepared.turns.push_back(segment.last);
    if (segment.phase != CurvePhase::Loading)
    {
      continue;
    }
    // The hold is either a recorded phase, or consists of the readings between the branches. It
    // includes readings that are displaced by noise of the depth.
    const bool isNext = s + 1 < segments.size();
    const bool isHeld = isNext && segments[s + 1].phase == CurvePhase::Hold;
    const std::size_t end = isHeld ? segments[s + 1].last
      : isNext                     ? segments[s + 1].first
                                   : curve.force.size() - 1;
    std::size_t start = segment.first;
    while (start < segment.last &&
      std::abs(curve.deflection[start] - curve.deflection[segment.last]) > NearlyShare * range)
    {
      ++start;
    }
    const double loss = lossOf(curve, start, end);
    if (!(std::abs(loss) <= std::abs(prepared.holdLoss)) && !std::isnan(loss))
    {
      prepared.holdLoss = loss;
    }
  }
  std::sort(prepared.turns.begin(), prepared.turns.end());
  prepared.turns.erase(
    std::unique(prepared.turns.begin(), prepared.turns.end()), prepared.turns.end());
}

LoadingBranch copyBranch(const MeasuredCurve& curve, const Segment& loading)
{
  LoadingBranch branch;
  for (std::size_t i = loading.first; i <= loading.last; ++i)
  {
    branch.deflection.push_back(curve.deflection[i]);
    branch.force.push_back(curve.force[i]);
  }
  if (!curve.time.empty())
  {
    const double duration = curve.time[loading.last] - curve.time[loading.first];
    branch.speed = (curve.deflection[loading.last] - curve.deflection[loading.first]) / duration;
  }
  return branch;
}

double rateEffectOf(const MeasuredCurve& curve, const std::vector<Segment>& loadings,
  const std::vector<LoadingBranch>& loads)
{
  std::size_t slow = 0;
  std::size_t fast = 0;
  for (std::size_t i = 0; i < loads.size(); ++i)
  {
    slow = loads[i].speed < loads[slow].speed ? i : slow;
    fast = loads[i].speed > loads[fast].speed ? i : fast;
  }
  if (!(std::isfinite(loads[fast].speed) && loads[fast].speed >= SpeedRatio * loads[slow].speed))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const Span both =
    common(spanOf(curve.deflection, loadings[slow]), spanOf(curve.deflection, loadings[fast]));
  const double slowly = energy(curve.deflection, curve.force, loadings[slow], both.low, both.high);
  const double fastly = energy(curve.deflection, curve.force, loadings[fast], both.low, both.high);
  return 2.0 * (fastly - slowly) / (fastly + slowly);
}

std::string exceeds(const char* what, double share, double limit)
{
  char text[160];
  std::snprintf(text, sizeof text,
    "%s is %.1f %% of the energy, more than the %.1f %% allowed: not the curve of an elastic body",
    what, 100.0 * share, 100.0 * limit);
  return text;
}
} // namespace

std::string prepareCurve(
  const MeasuredCurve& curve, const ElasticityLimits& limits, PreparedCurve& prepared)
{
  prepared = {};
  if (curve.deflection.size() < 2)
  {
    return "there is no loading: only " + std::to_string(curve.deflection.size()) + " reading";
  }
  const auto extremes = std::minmax_element(curve.deflection.begin(), curve.deflection.end());
  const double range = *extremes.second - *extremes.first;
  const bool recorded = std::any_of(curve.phase.begin(), curve.phase.end(),
    [](CurvePhase phase) { return phase != CurvePhase::Unknown; });
  const std::vector<Segment> segments =
    recorded ? recordedSegments(curve.phase) : foundSegments(curve.deflection, range);

  judgeHolds(curve, segments, range, prepared);

  std::vector<Segment> loadings;
  for (const Segment& segment : segments)
  {
    if (segment.phase == CurvePhase::Loading && segment.last > segment.first)
    {
      loadings.push_back(segment);
      prepared.loads.push_back(copyBranch(curve, segment));
    }
    else if (segment.phase == CurvePhase::Unloading && !loadings.empty())
    {
      LoadingBranch& load = prepared.loads.back();
      load.hysteresis = hysteresisOf(curve, loadings.back(), segment);
      if (!(std::abs(load.hysteresis) <= std::abs(prepared.hysteresis)))
      {
        prepared.hysteresis = load.hysteresis;
      }
    }
  }
  if (loadings.empty())
  {
    return "there is no loading: the deflection never increases";
  }
  prepared.rateEffect = rateEffectOf(curve, loadings, prepared.loads);
  if (std::abs(prepared.hysteresis) > limits.hysteresis)
  {
    return exceeds("hysteresis", prepared.hysteresis, limits.hysteresis);
  }
  if (std::abs(prepared.rateEffect) > limits.rateEffect)
  {
    return exceeds("the effect of speed", std::abs(prepared.rateEffect), limits.rateEffect);
  }
  return {};
}

bool relaxes(const PreparedCurve& prepared, const ElasticityLimits& limits)
{
  const bool contrary =
    prepared.hysteresis < -limits.hysteresis || prepared.rateEffect < -limits.rateEffect;
  return !contrary &&
    (prepared.hysteresis > limits.hysteresis || prepared.rateEffect > limits.rateEffect ||
      prepared.holdLoss > limits.rateEffect);
}
} // namespace palpate
