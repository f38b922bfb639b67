// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Numerics/IsotonicRegression.h"

#include <cstddef>

namespace palpate
{
std::vector<double> isotonicRegression(
  const std::vector<double>& values, const std::vector<double>& weights)
{
  struct Block
  {
    double sum;
    double weight;
    std::size_t count;
    double mean() const { return this->sum / this->weight; }
  };
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double weight = weights.empty() ? 1.0 : weights[i];
    Block block{ values[i] * weight, weight, 1 };
    while (!blocks.empty() && blocks.back().mean() > block.mean())
    {
      block.sum += blocks.back().sum;
      block.weight += blocks.back().weight;
      block.count += blocks.back().count;
      blocks.pop_back();
    }
    blocks.push_back(block);
  }
  std::vector<double> fitted;
  fitted.reserve(values.size());
  for (const Block& block : blocks)
  {
    fitted.insert(fitted.end(), block.count, block.mean());
  }
  return fitted;
}
} // namespace palpate
