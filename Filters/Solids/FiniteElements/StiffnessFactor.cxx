// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/FiniteElements/StiffnessFactor.h"

#include "Solids/FiniteElements/SimplicialFactor.h"
#include "Solids/FiniteElements/SupernodalFactor.h"

#include <algorithm>
#include <limits>

namespace palpate
{
std::unique_ptr<StiffnessFactor> StiffnessFactor::make(Kind kind)
{
  std::unique_ptr<StiffnessFactor> factor;
  if (kind != Kind::Simplicial)
  {
    factor = makeSupernodalFactor();
  }
  if (kind == Kind::Simplicial || (kind == Kind::Automatic && !factor))
  {
    factor = std::make_unique<SimplicialFactor>();
  }
  return factor;
}

std::vector<std::size_t> orderLoads(
  const std::vector<SparseLoad>& loads, const std::vector<int>& position)
{
  std::vector<std::pair<int, std::size_t>> keys;
  for (std::size_t i = 0; i < loads.size(); ++i)
  {
    int first = std::numeric_limits<int>::max();
    for (const auto& [unknown, force] : loads[i])
    {
      first = std::min(first, position[static_cast<std::size_t>(unknown)]);
    }
    if (!loads[i].empty())
    {
      keys.emplace_back(first, i);
    }
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::size_t> order;
  order.reserve(keys.size());
  for (const auto& key : keys)
  {
    order.push_back(key.second);
  }
  return order;
}
} // namespace palpate
