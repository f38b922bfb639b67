// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/ArrangedReadings.h"

#include "Identification/FitVerdict.h"
#include "Identification/ForceNoise.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int ScanGroups = 100;
constexpr int ScanCandidates = 60;
// Largest distance of first contact before the first reading, as a fraction of the range.
constexpr double ScanBefore = 0.5;
constexpr int MostScans = 12;
// Length of the baseline, in multiples of the depth of contact.
constexpr double BaselineDepths = 4.0;
constexpr std::size_t EnoughBefore = 30;
constexpr std::size_t MostReadings = 200; // if there are more readings, they are averaged
constexpr int ContactGroups = 160;
constexpr int BaselineGroups = 40;
// Value of the noise if the noise is not known.
constexpr double Unknown = std::numeric_limits<double>::infinity();
// Fraction of the depth of contact. Within this distance before first contact, groups of readings
// are as fine as in contact.
constexpr double KinkShare = 0.1;

/// Appends the averages of the readings `first` <= i < `last` over `count` equal intervals of
/// depth.
void appendGroups(const IndentationCurve& curve, std::size_t first, std::size_t last, int count,
  IndentationCurve& groups)
{
  if (first >= last)
  {
    return;
  }
  const double low = curve.deflection[first];
  const double width = (curve.deflection[last - 1] - low) / count;
  const auto groupOf = [&](std::size_t reading)
  {
    return width > 0.0
      ? std::min(count - 1, static_cast<int>((curve.deflection[reading] - low) / width))
      : 0;
  };
  for (std::size_t i = first; i < last;)
  {
    const int group = groupOf(i);
    double deflection = 0.0;
    double force = 0.0;
    std::size_t end = i;
    for (; end < last && groupOf(end) == group; ++end)
    {
      deflection += curve.deflection[end];
      force += curve.force[end];
    }
    const auto readings = static_cast<double>(end - i);
    groups.append(deflection / readings, force / readings, readings);
    i = end;
  }
}

/// A half-space and a baseline, fitted for one assumed depth of first contact.
struct Candidate
{
  FirstContact contact;
  double squares = std::numeric_limits<double>::infinity();
};

/// Returns the best E*, offset and drift for first contact at the given depth, by linear least
/// squares.
Candidate fitAt(const IndentationCurve& groups, double depth, bool hasBaseline)
{
  Candidate result;
  result.contact.depth = depth;
  result.contact.baseline.reference = depth;
  const auto count = static_cast<Index>(groups.force.size());
  const double contactDepth = groups.deflection.back() - depth;
  double before = 0.0;
  MatrixXd columns(count, 3);
  VectorXd forces(count);
  for (Index i = 0; i < count; ++i)
  {
    const auto k = static_cast<std::size_t>(i);
    const double weight = std::sqrt(groups.readings[k]);
    const double local = groups.deflection[k] - depth;
    before += local < 0.0 ? groups.readings[k] : 0.0;
    columns.row(i) << weight * groups.tool->force(local, 1.0), weight, weight * local;
    forces[i] = weight * groups.force[k];
  }
  if (!columns.allFinite() || !(columns(count - 1, 0) > 0.0))
  {
    return result;
  }
  const BaselineTerms terms = hasBaseline
    ? baselineTerms(before, depth - groups.deflection.front(), contactDepth, Unknown)
    : BaselineTerms::None;
  const auto solve = [&](Index inputs, const VectorXd& wanted)
  {
    VectorXd found = VectorXd::Zero(3);
    found.head(inputs) = columns.leftCols(inputs).householderQr().solve(wanted);
    return found;
  };
  VectorXd found = solve(1 + static_cast<Index>(terms), forces);
  const double most = LargestDrift * groups.tool->force(contactDepth, found[0]) / contactDepth;
  if (found[0] > 0.0 && std::abs(found[2]) > most)
  {
    const double drift = std::copysign(most, found[2]);
    found = solve(2, forces - drift * columns.col(2));
    found[2] = drift;
  }
  if (found[0] > 0.0)
  {
    result.contact.modulus = found[0];
    result.contact.baseline.offset = found[1];
    result.contact.baseline.drift = found[2];
    result.contact.terms = terms;
    result.squares = (columns * found - forces).squaredNorm();
  }
  return result;
}
} // namespace

BaselineTerms baselineTerms(double readings, double range, double depth, double noise)
{
  constexpr double fewest = 4.0;
  constexpr double fewestForDrift = 8.0;
  constexpr double longEnough = 0.5;
  constexpr double wellEnough = 0.01;
  if (readings < fewest)
  {
    return BaselineTerms::None;
  }
  // The error of the force over the depth, which follows from the standard error of the slope of a
  // line through evenly spaced readings.
  const double error =
    std::max(noise, FitLimits::LeastNoise) * depth * std::sqrt(12.0 / readings) / range;
  return readings >= fewestForDrift && (range >= longEnough * depth || error <= wellEnough)
    ? BaselineTerms::OffsetAndDrift
    : BaselineTerms::Offset;
}

IndentationCurve loadsByDepth(const AxisymmetricTool& tool, const PreparedCurve& prepared)
{
  std::vector<std::pair<double, double>> readings;
  for (const LoadingBranch& load : prepared.loads)
  {
    for (std::size_t i = 0; i < load.force.size(); ++i)
    {
      readings.emplace_back(load.deflection[i], load.force[i]);
    }
  }
  std::stable_sort(readings.begin(), readings.end(),
    [](const auto& a, const auto& b) { return a.first < b.first; });
  IndentationCurve loading;
  loading.tool = &tool;
  for (const auto& [deflection, force] : readings)
  {
    loading.append(deflection, force, 1.0);
  }
  return loading;
}

FirstContact findFirstContact(const IndentationCurve& curve)
{
  const std::vector<double>& depths = curve.deflection;
  FirstContact found;
  found.depth = depths.front();
  std::size_t first = 0;
  for (int scan = 0; scan < MostScans; ++scan)
  {
    IndentationCurve groups;
    groups.tool = curve.tool;
    appendGroups(curve, first, depths.size(), ScanGroups, groups);
    const double range = depths.back() - depths[first];
    const double start = depths[first] - (first == 0 ? ScanBefore * range : 0.0);
    const double step = (depths.back() - start) / ScanCandidates;
    Candidate best;
    for (int i = 0; i < ScanCandidates; ++i)
    {
      Candidate candidate = fitAt(groups, start + step * i, true);
      if (candidate.squares < best.squares)
      {
        best = candidate;
      }
    }
    if (!std::isfinite(best.squares))
    {
      return found;
    }
    found = best.contact;
    // If most of the scanned range precedes the contact, scans a shorter range.
    const double contactDepth = depths.back() - found.depth;
    const double from = found.depth - (BaselineDepths - 1.0) * contactDepth - step;
    const auto next = static_cast<std::size_t>(
      std::lower_bound(depths.begin(), depths.end(), from) - depths.begin());
    const std::size_t least = static_cast<std::size_t>(
      std::lower_bound(depths.begin(), depths.end(), found.depth - step) - depths.begin());
    const std::size_t closer = std::min(next, least > EnoughBefore ? least - EnoughBefore : 0);
    if (closer <= first || depths[closer] - depths[first] < 0.1 * range)
    {
      return found;
    }
    first = closer;
  }
  return found;
}

IndentationCurve arrangeReadings(const IndentationCurve& curve, bool findContact)
{
  IndentationCurve arranged;
  arranged.tool = curve.tool;
  const std::vector<double>& depths = curve.deflection;
  const auto indexOf = [&depths](double depth)
  {
    return static_cast<std::size_t>(
      std::lower_bound(depths.begin(), depths.end(), depth) - depths.begin());
  };
  std::size_t first = 0;
  std::size_t middle = 0; // index of the first reading in the fine groups
  if (findContact)
  {
    FirstContact& start = arranged.start;
    start = findFirstContact(curve);
    const double contactDepth = depths.back() - start.depth;
    const std::size_t begin = indexOf(start.depth);
    first = std::min(indexOf(start.depth - BaselineDepths * contactDepth),
      begin > EnoughBefore ? begin - EnoughBefore : 0);
    middle = std::max(first, indexOf(start.depth - KinkShare * contactDepth));
    const double largest = curve.tool->force(contactDepth, start.modulus);
    const double noise = estimateForceNoise(depths, curve.force).deviation / largest;
    start.terms = baselineTerms(
      static_cast<double>(begin - first), start.depth - depths[first], contactDepth, noise);
    start.baseline.offset = start.terms == BaselineTerms::None ? 0.0 : start.baseline.offset;
    start.baseline.drift =
      start.terms == BaselineTerms::OffsetAndDrift ? start.baseline.drift : 0.0;
  }
  if (depths.size() - first <= MostReadings)
  {
    for (std::size_t i = first; i < depths.size(); ++i)
    {
      arranged.append(depths[i], curve.force[i], 1.0);
    }
  }
  else
  {
    appendGroups(curve, first, middle, BaselineGroups, arranged);
    appendGroups(curve, middle, depths.size(), ContactGroups, arranged);
  }
  if (!findContact)
  {
    arranged.start = fitAt(arranged, 0.0, false).contact;
  }
  return arranged;
}
} // namespace palpate
