// SPDX-License-Identifier: BSD-3-Clause
#include "Trials/TrialPlan.h"

#include <cstddef>
#include <random>
#include <utility>

namespace palpate
{
namespace
{
/// Returns a random number below `count`, uniformly distributed. The distributions and the shuffle
/// of the standard library are not used, because their results differ between implementations.
std::size_t drawBelow(std::mt19937_64& random, std::size_t count)
{
  const std::uint64_t largest = std::mt19937_64::max();
  const std::uint64_t whole = largest - largest % count; // a multiple of count
  std::uint64_t number = random();
  while (number >= whole)
  {
    number = random();
  }
  return static_cast<std::size_t>(number % count);
}
} // namespace

std::vector<Trial> planTrials(int alternatives, int rounds, std::uint64_t seed)
{
  std::vector<Trial> round;
  for (int x = 0; x < alternatives; ++x)
  {
    for (int y = 0; y < alternatives; ++y)
    {
      if (x != y)
      {
        round.push_back({ x, y });
      }
    }
  }
  std::mt19937_64 random(seed);
  std::vector<Trial> plan;
  for (int i = 0; i < rounds; ++i)
  {
    for (std::size_t left = round.size(); left > 1; --left)
    {
      std::swap(round[left - 1], round[drawBelow(random, left)]);
    }
    plan.insert(plan.end(), round.begin(), round.end());
  }
  return plan;
}
} // namespace palpate
