// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/CurveSigns.h"

#include "Identification/ForceNoise.h"
#include "Identification/StrainWindow.h"
#include "Mechanics/Files/NumberText.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace palpate
{
namespace
{
// Smallest ratio of the change in one direction to the change in the opposite direction.
constexpr double SignRatio = 3.0;
// Smallest significant change, in standard deviations of the noise.
constexpr double NoiseFactor = 8.0;
// Fraction of the change of force. If the first force is smaller, the first readings are without
// contact.
constexpr double ContactFraction = 0.25;
// Smallest significant change of depth, as a fraction of the range of deflection.
constexpr double DepthFraction = 0.1;
// Largest number of readings that count as the first readings.
constexpr std::size_t MostStartReadings = 20;
constexpr double UnitStrain = 0.4;   // contact radius divided by tip radius, for the check of units
constexpr double DepthRatio = 100.0; // implausible depth, as a multiple of the depth at UnitStrain

double median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Returns the noise of the forces, N, estimated from readings that are neighbours in depth.
double noiseOf(const MeasuredCurve& curve, const std::vector<std::size_t>& byDepth)
{
  std::vector<double> depths;
  std::vector<double> forces;
  for (const std::size_t i : byDepth)
  {
    depths.push_back(curve.deflection[i]);
    forces.push_back(curve.force[i]);
  }
  return estimateForceNoise(depths, forces).deviation;
}

std::string fromTo(double from, double to, const char* unit)
{
  // Adding 0.0 avoids the text "-0".
  return "from " + shortly(from + 0.0) + " to " + shortly(to + 0.0) + " " + unit;
}
} // namespace

std::string doubtSigns(const MeasuredCurve& curve)
{
  const std::size_t count = curve.force.size();
  if (count < 4)
  {
    return {};
  }
  const auto few = static_cast<std::ptrdiff_t>(std::min(MostStartReadings, 1 + count / 100));
  const double force = median({ curve.force.begin(), curve.force.begin() + few });
  const double depth = median({ curve.deflection.begin(), curve.deflection.begin() + few });
  const auto [low, high] = std::minmax_element(curve.deflection.begin(), curve.deflection.end());
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  const auto sortBy = [&order](const std::vector<double>& values)
  {
    std::stable_sort(order.begin(), order.end(),
      [&values](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  };
  sortBy(curve.deflection);
  const double noise = NoiseFactor * noiseOf(curve, order);
  sortBy(curve.force);
  // The lowest and highest readings may be outliers.
  const std::size_t skipped = std::min<std::size_t>(2, count / 8);
  const std::size_t lowest = order[skipped];
  const std::size_t highest = order[count - 1 - skipped];
  const double fall = force - curve.force[lowest];
  const double rise = curve.force[highest] - force;
  const double some = DepthFraction * (*high - *low);
  if (fall > std::max(SignRatio * rise, noise))
  {
    const double deepest = curve.deflection[lowest];
    const std::string forces = fromTo(force, curve.force[lowest], "N");
    if (deepest > depth + some)
    {
      return "forces fall " + forces + " while the deflection rises " +
        fromTo(depth, deepest, "mm") +
        ": is compression negative here? Then write '# negative: force' in the head of the file";
    }
    if (deepest < depth - some && std::abs(force) < ContactFraction * fall)
    {
      return "forces fall " + forces + " while the deflection falls " +
        fromTo(depth, deepest, "mm") +
        ": are both negative here? Then write '# negative: deflection, force' in the head of the "
        "file";
    }
  }
  const double deepest = curve.deflection[highest];
  if (rise > std::max(SignRatio * fall, noise) && deepest < depth - some)
  {
    return "the deflection falls " + fromTo(depth, deepest, "mm") + " while forces rise " +
      fromTo(force, curve.force[highest], "N") +
      ": is it a height, or compression negative here? Then write '# negative: deflection' in the "
      "head of the file";
  }
  return {};
}

std::string doubtUnits(const AxisymmetricTool& tool, double depth)
{
  const double small = smallStrainDepth(tool, {}, nullptr, UnitStrain);
  if (!(depth > DepthRatio * small))
  {
    return {};
  }
  const bool isMicro = depth < 1e3 * DepthRatio * small;
  return "the deflection goes " + shortly(depth) +
    " mm beyond first contact, where strains are small to " + shortly(small) + " mm under " +
    tool.specification() + ": is it in " + (isMicro ? "um" : "nm") + "? Then name its column " +
    (isMicro ? "deflection_um" : "deflection_nm");
}
} // namespace palpate
