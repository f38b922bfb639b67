// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tilt/ToolDrop.h"

#include "Mechanics/Numerics/CubicCell.h"
#include "Mechanics/Tilt/TiltGeometry.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace palpate
{
ToolDrop::ToolDrop(const AxisymmetricTool& tool, double largest)
  : Largest(largest)
{
  for (int k = 0; k < Angles; ++k)
  {
    // Not at 0 itself: a rim is the deepest point as soon as there is a tilt.
    constexpr double Hardly = 1e-9;
    const double angle = std::max(Hardly, static_cast<double>(k) / (Angles - 1)) * largest;
    const DeepestPoint deepest = deepestPoint(tool, angle);
    this->Nodes.push_back(k == 0 ? 0.0 : deepest.drop);
    this->Nodes.push_back(deepest.offset);
  }
}

DeepestPoint ToolDrop::at(double angle) const
{
  constexpr int Cells = Angles - 1;
  const double width = this->Largest / Cells;
  const double place = angle / width;
  const int cell = std::clamp(static_cast<int>(place), 0, Cells - 1);
  const double* node = this->Nodes.data() + 2 * static_cast<std::size_t>(cell);
  if (angle >= this->Largest)
  {
    return { node[2] + (angle - this->Largest) * node[3], node[3] };
  }
  const double t = place - cell;
  const CubicCell drop(node[2] - node[0], node[1] * width, node[3] * width);
  return { node[0] + drop.value(t), drop.slope(t) / width };
}

} // namespace palpate
