// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/TiltNeed.h"

#include "Mechanics/JoinedText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace palpate
{
namespace
{
/// In two digits.
std::string inPercent(double share)
{
  const double percent = 100.0 * share;
  const double unit = percent > 0.0 ? std::pow(10.0, std::floor(std::log10(percent)) - 1.0) : 1.0;
  return joined(std::round(percent / unit) * unit, " %");
}
} // namespace

TiltNeed tiltNeed(const ResponseArrays& arrays, double tolerance)
{
  constexpr int angles = 8;
  constexpr std::size_t mostPoints = 4096;
  TiltNeed need;
  const TiltViews& tilts = arrays.tilt;
  if (!tilts.areFelt())
  {
    return need;
  }
  const TiltTable table(tilts.terms, tilts.drops, tilts.nodes);
  const ResponseField field(arrays);
  const auto laws = static_cast<std::size_t>(tilts.terms.laws);
  const std::size_t step = std::max<std::size_t>(1, arrays.points / mostPoints);
  std::size_t seen = 0;
  std::size_t without = 0;
  for (std::size_t i = 0; i < arrays.points; i += step)
  {
    if (!arrays.isUsable(i))
    {
      continue;
    }
    const auto point = static_cast<std::int32_t>(i);
    std::array<double, TiltTerms::MostLaws> weights{ 1.0 };
    if (tilts.weight)
    {
      std::copy_n(tilts.weight + laws * i, laws, weights.begin());
    }
    const double tip = 0.5 * field.range(point);
    const double upright = field.evaluate(point, tip).force;
    double worst = 0.0;
    for (int k = 1; k <= angles && upright > 0.0; ++k)
    {
      const double angle = tilts.terms.largest * k / angles;
      const DeepestPoint deepest = table.deepest(angle);
      const double depth = tip + deepest.drop;
      const TiltFactor factor = table.at(depth, angle, weights.data());
      const double work = field.energy(point, depth);
      const double force =
        field.evaluate(point, depth).force * factor.value + work * factor.byDepth;
      const double change = std::abs(force / upright - 1.0);
      need.torque = std::max(need.torque, std::abs(force * deepest.offset + work * factor.byAngle));
      worst = std::max(worst, change);
      if (change > need.change)
      {
        need.change = change;
        need.angle = angle;
      }
    }
    ++seen;
    without += worst <= tolerance ? 1 : 0;
  }
  need.without = seen > 0 ? static_cast<double>(without) / static_cast<double>(seen) : 1.0;
  need.isFelt = need.change > tolerance;
  return need;
}

std::string tiltReason(const TiltNeed& need, const TiltViews& tilts, double tolerance)
{
  if (!tilts.areFelt())
  {
    return {};
  }
  constexpr double degrees = 57.29577951308232;
  const double torque = std::round(100.0 * need.torque) / 100.0;
  if (!need.isFelt)
  {
    return joined("tilts of the tool are left out: up to ",
      std::round(degrees * tilts.terms.largest), " degrees they change its force by no more than ",
      inPercent(need.change), ", within ", inPercent(tolerance), ", and its torque is ", torque,
      " N mm at most");
  }
  std::string words =
    joined("a tilt of ", std::round(degrees * need.angle), " degrees changes the force by ",
      inPercent(need.change), " where it does most, with ", torque, " N mm at most");
  if (need.without > 0.0)
  {
    words += joined("; at ", std::floor(1000.0 * need.without) / 10.0,
      " % of the points no tilt changes it by more than ", inPercent(tolerance));
  }
  return words;
}
} // namespace palpate
