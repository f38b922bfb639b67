// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/PunchDepths.h"

#include <array>

namespace palpate
{
namespace
{
/// Depths relative to the radius. They resolve the deviation of the curve from a straight line due
/// to strain.
constexpr std::array Depths = { 0.05, 0.2, 0.4, 0.7, 1.0, 1.4 };

/// Depths relative to the depth of full contact, and the error of the force at each depth due to
/// the unsolved shape of the contact at smaller depths. The errors were measured in the same way as
/// GapErrorFactor (ContactHarmonics).
constexpr std::array<PunchDepth, 5> ClosedDepths = { { { 0.5, 0.2 }, { 0.75, 0.06 }, { 1.0, 0.03 },
  { 1.5, 0.01 }, { 5.0, 0.003 } } };

/// Forces relative to the force at full contact.
constexpr std::array PartsOfClosing = { 0.01, 0.03, 0.06, 0.1, 0.2, 0.35, 0.5, 0.7, 0.85, 1.0 };
} // namespace

std::vector<PunchDepth> punchDepths(double radius, const PunchClosing& closing)
{
  std::vector<PunchDepth> found;
  if (closing.isSolved && closing.depth > 0.0)
  {
    for (const double part : PartsOfClosing)
    {
      if (part > closing.carried)
      {
        found.push_back({ closing.depth - (1.0 - part) * closing.sink, 0.0 });
      }
    }
  }
  for (const PunchDepth& closed : ClosedDepths)
  {
    if (closing.depth > 0.0 && (!closing.isSolved || closed.depth > 1.0))
    {
      found.push_back({ closed.depth * closing.depth, closing.isSolved ? 0.0 : closed.open });
    }
  }
  const double last = ClosedDepths.back().depth * closing.depth;
  for (const double depth : Depths)
  {
    if (depth * radius > last)
    {
      found.push_back({ depth * radius, ClosedDepths.back().open * last / (depth * radius) });
    }
  }
  return found;
}
} // namespace palpate
