// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/TiltNeed.h"

#include "Laws/TiltedCurves.h"
#include "Mechanics/Files/NumberText.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Numerics/Constants.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace palpate
{
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
  const TiltedCurves curves(arrays);
  const std::size_t step = std::max<std::size_t>(1, arrays.points / mostPoints);
  std::size_t seen = 0;
  std::size_t without = 0;
  for (std::size_t i = 0; i < arrays.points; i += step)
  {
    if (!arrays.isUsable(i))
    {
      continue;
    }
    const double tip = 0.5 * static_cast<double>(arrays.range[i]);
    const double upright = curves.upright().evaluate(static_cast<std::int32_t>(i), tip).force;
    double worst = 0.0;
    for (int k = 1; k <= angles && upright > 0.0; ++k)
    {
      const double angle = tilts.terms.largest * k / angles;
      const TiltedCurves::Felt felt = curves.at(i, tip + curves.table().deepest(angle).drop, angle);
      const double change = std::abs(felt.force / upright - 1.0);
      need.torque = std::max(need.torque, std::abs(felt.torque));
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
  constexpr double degrees = 180.0 / Pi;
  const double torque = std::round(100.0 * need.torque) / 100.0;
  if (!need.isFelt)
  {
    return joined("tilts of the tool are left out: up to ",
      std::round(degrees * tilts.terms.largest), " degrees they change its force by no more than ",
      inPercent(need.change), ", within ", inPercent(tolerance), ", and its torque is ", torque,
      " N mm at most");
  }
  std::string words = joined("a tilt of ", std::round(degrees * need.angle),
    " degrees changes the force by ", inPercent(need.change),
    " at the point where its effect is largest, with a torque of ", torque, " N mm at most");
  if (need.without > 0.0)
  {
    words += joined("; at ", std::floor(1000.0 * need.without) / 10.0,
      " % of the points no tilt changes it by more than ", inPercent(tolerance));
  }
  return words;
}
} // namespace palpate
