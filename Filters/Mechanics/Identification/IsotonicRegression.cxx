// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Identification/IsotonicRegression.h"

#include <cstddef>

namespace palpate
{
std::vector<double> isotonicRegression(const std::vector<double>& values)
{
  struct Block
  {
    double sum;
    std::size_t count;
    double mean() const { return this->sum / static_cast<double>(this->count); }
  };
  std::vector<Block> blocks;
  for (const double value : values)
  {
    Block block{ value, 1 };
    while (!blocks.empty() && blocks.back().mean() > block.mean())
    {
      block.sum += blocks.back().sum;
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
