// SPDX-License-Identifier: BSD-3-Clause
#ifndef MemoryText_h
#define MemoryText_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace palpate
{
/// Returns a text about the memory part of a normal force (N): "of 3.20 N 0.900 N are memory (28
/// %)". During unloading the memory part is negative, and the text gives its fraction of the slow
/// force: "of 3.20 N memory takes 0.900 N (28 %)". Returns "" if the fraction is below 1 %, for
/// example for a body that does not relax.
inline std::string memoryInWords(double normalForce, double memory)
{
  constexpr double Least = 0.01;
  const double whole = std::max(normalForce, normalForce - memory);
  const double share = std::abs(memory) / whole;
  if (!(share >= Least))
  {
    return {};
  }
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(),
    memory > 0.0 ? "of %#.3g N %#.3g N are memory (%.0f %%)"
                 : "of %#.3g N memory takes %#.3g N (%.0f %%)",
    whole, std::abs(memory), 100.0 * share);
  return text.data();
}
} // namespace palpate

#endif
