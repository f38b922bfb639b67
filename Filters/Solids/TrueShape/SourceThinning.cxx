// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/SourceThinning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace palpate
{
namespace
{
constexpr double SameSide = 0.5; // cos 60°, for the largest angle between normals on the same side
} // namespace

std::vector<std::int32_t> thinnedSources(const BodySurface& surface,
  const std::vector<std::int32_t>& candidates, const std::vector<double>& spacings)
{
  double largest = 0.0;
  for (const double spacing : spacings)
  {
    largest = std::max(largest, spacing);
  }
  if (!(largest > 0.0))
  {
    return candidates;
  }
  using Box = std::array<long, 3>;
  std::map<Box, std::vector<std::size_t>> kept; // indices of the kept candidates, by box
  std::vector<std::int32_t> sources;
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    const Eigen::Vector3d& at = surface.position(candidates[i]);
    Box box;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      box[axis] = std::lround(std::floor(at[static_cast<Eigen::Index>(axis)] / largest));
    }
    const auto stands = [&](std::size_t other)
    {
      const double near = (1.0 - 1e-9) * std::min(spacings[i], spacings[other]);
      return (surface.position(candidates[other]) - at).norm() < near &&
        surface.normal(candidates[other]).dot(surface.normal(candidates[i])) > SameSide;
    };
    bool isReplaced = false;
    for (int neighbour = 0; neighbour < 27 && !isReplaced; ++neighbour)
    {
      const Box adjacent = { box[0] + neighbour % 3 - 1, box[1] + neighbour / 3 % 3 - 1,
        box[2] + neighbour / 9 - 1 };
      const auto found = kept.find(adjacent);
      isReplaced =
        found != kept.end() && std::any_of(found->second.begin(), found->second.end(), stands);
    }
    if (!isReplaced)
    {
      kept[box].push_back(i);
      sources.push_back(candidates[i]);
    }
  }
  return sources;
}
} // namespace palpate
