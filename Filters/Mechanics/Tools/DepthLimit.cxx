// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tools/DepthLimit.h"
#include "Mechanics/Numerics/Constants.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
constexpr double Tolerance = 1e-3;          // relative to the depth, see the header
constexpr std::size_t LeastSamples = 512;   // smallest total number of samples of g
constexpr double SamplesPerFactor = 12.0;   // number of samples per factor of e in the radius
constexpr std::size_t MostCandidates = 512; // largest number of radii at which the gap is computed

struct Sample
{
  double x;
  double g;
};

/// Returns samples of g between the kinks. They are evenly spaced before the first kink. Just
/// beyond a kink of radius r the samples are denser, because g may start like a square root. At
/// larger x their distance is proportional to x, because g changes over lengths of the order of r,
/// even if the next kink is far away.
std::vector<Sample> sampleBetween(const std::function<double(double)>& reducedProfile,
  const std::vector<double>& kinks, double outer)
{
  std::vector<double> ends;
  for (const double kink : kinks)
  {
    if (kink > 0.0 && kink < outer)
    {
      ends.push_back(kink);
    }
  }
  ends.push_back(outer);
  const std::size_t perPiece = std::max<std::size_t>(8, LeastSamples / ends.size());
  std::vector<Sample> samples = { { 0.0, 0.0 } };
  double begin = 0.0;
  for (const double end : ends)
  {
    const double span =
      begin > 0.0 ? std::acosh(std::min(end / begin, std::numeric_limits<double>::max())) : 0.0;
    const std::size_t count = std::max(perPiece, static_cast<std::size_t>(SamplesPerFactor * span));
    for (std::size_t i = 1; i <= count; ++i)
    {
      const double share = static_cast<double>(i) / static_cast<double>(count);
      const double inside = begin > 0.0 ? begin * std::cosh(span * share) : end * share;
      const double x = i == count ? end : inside;
      samples.push_back({ x, reducedProfile(x) });
    }
    begin = end;
  }
  return samples;
}

/// Returns the radii at which the gap may close. Beyond a maximum of g there is a dip, in which g
/// is smaller. The radii extend to twice the distance from the maximum to the end of the dip.
std::vector<double> candidates(const std::vector<Sample>& samples)
{
  std::vector<double> radii;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i)
  {
    const double level = samples[i].g;
    std::size_t end = i + 1;
    double lowest = level;
    while (end < samples.size() && samples[end].g < level)
    {
      lowest = std::min(lowest, samples[end].g);
      ++end;
    }
    // The gap cannot be more negative than the dip of g, because (2/π) ∫ dx/√(r²-x²) <= 1.
    if (level - lowest > Tolerance * level)
    {
      const double dipEnd = samples[std::min(end, samples.size() - 1)].x;
      const double last = 2.0 * dipEnd - samples[i].x;
      for (std::size_t k = i + 1; k < samples.size() && samples[k].x <= last; ++k)
      {
        radii.push_back(samples[k].x);
      }
    }
    i = end - 1;
  }
  const std::size_t stride = radii.size() / MostCandidates + 1;
  std::vector<double> thinned;
  for (std::size_t i = 0; i < radii.size(); i += stride)
  {
    thinned.push_back(radii[radii.size() - 1 - i]);
  }
  return thinned;
}

/// Returns the depth at which the gap at r closes while the contact grows over the samples. It is
/// the first depth at which δ - f(r) - u_z(r) exceeds the tolerance.
double closingDepth(const std::vector<Sample>& samples, double r, double height)
{
  double integral = 0.0; // ∫_0^x g dx/√(r²-x²), with g linear between samples
  double deepest = 0.0;
  double before = -height;
  double depthBefore = 0.0;
  for (std::size_t i = 0; i + 1 < samples.size() && samples[i + 1].x < r; ++i)
  {
    const Sample& p = samples[i];
    const Sample& q = samples[i + 1];
    const double slope = (q.g - p.g) / (q.x - p.x);
    const double rootP = std::sqrt((r - p.x) * (r + p.x));
    const double rootQ = std::sqrt((r - q.x) * (r + q.x));
    const double angle = std::asin(q.x / r);
    integral += (p.g - slope * p.x) * (angle - std::asin(p.x / r)) + slope * (rootP - rootQ);
    if (q.g <= deepest)
    {
      continue; // no contact has this radius
    }
    deepest = q.g;
    const double over = q.g * (1.0 - 2.0 / Pi * angle - Tolerance) - height + 2.0 / Pi * integral;
    if (over > 0.0)
    {
      return depthBefore - before * (q.g - depthBefore) / (over - before);
    }
    before = over;
    depthBefore = q.g;
  }
  return std::numeric_limits<double>::infinity();
}
} // namespace

DepthLimit findDepthLimit(const std::function<double(double)>& profile,
  const std::function<double(double)>& reducedProfile, const std::vector<double>& kinks,
  double outer)
{
  const std::vector<Sample> samples = sampleBetween(reducedProfile, kinks, outer);
  DepthLimit limit;
  for (const double r : candidates(samples))
  {
    const double depth = closingDepth(samples, r, profile(r));
    if (depth < limit.depth)
    {
      limit = { depth, r };
    }
  }
  return limit;
}
} // namespace palpate
