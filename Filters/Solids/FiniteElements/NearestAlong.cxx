// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/FiniteElements/NearestAlong.h"

#include <algorithm>
#include <queue>
#include <unordered_map>

namespace palpate
{
std::vector<AlongSurface> nearestAlong(const BodySurface& surface, std::int32_t point,
  std::size_t count, const std::function<bool(std::int32_t)>& isWanted)
{
  using Entry = std::pair<double, std::int32_t>;
  std::unordered_map<std::int32_t, double> distance = { { point, 0.0 } };
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  front.emplace(0.0, point);
  std::vector<AlongSurface> found;
  while (found.size() < count && !front.empty())
  {
    const auto [away, at] = front.top();
    front.pop();
    if (away > distance.at(at))
    {
      continue;
    }
    if (isWanted(at))
    {
      found.push_back({ at, away });
      continue; // paths must not pass through a found point
    }
    for (const std::int32_t* t = surface.trianglesBegin(at); t != surface.trianglesEnd(at); ++t)
    {
      for (const std::int32_t next : surface.triangle(*t))
      {
        const double length = away + (surface.position(next) - surface.position(at)).norm();
        const auto [known, isNew] = distance.emplace(next, length);
        if (isNew || length < known->second)
        {
          known->second = length;
          front.emplace(length, next);
        }
      }
    }
  }
  return found;
}

std::vector<double> weightsAlong(const std::vector<AlongSurface>& found)
{
  std::vector<double> weights;
  double sum = 0.0;
  for (const AlongSurface& each : found)
  {
    weights.push_back(1.0 / std::max(each.distance * each.distance, 1e-300));
    sum += weights.back();
  }
  for (double& weight : weights)
  {
    weight /= sum;
  }
  return weights;
}
} // namespace palpate
