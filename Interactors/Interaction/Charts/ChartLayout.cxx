// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Charts/ChartLayout.h"

#include "vtkChartXY.h"
#include "vtkRect.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr double Shape = 1.35; // width over height
constexpr float Margin = 6.0F; // pixels around a chart

int rowsOf(int count, int columns)
{
  return (count + columns - 1) / columns;
}

int columnsFor(int count, int width, int height)
{
  int best = 1;
  double largest = 0.0;
  for (int columns = 1; columns <= count; ++columns)
  {
    const double size =
      std::min(width / Shape / columns, static_cast<double>(height) / rowsOf(count, columns));
    if (size > largest)
    {
      largest = size;
      best = columns;
    }
  }
  return best;
}
} // namespace

void layOut(const std::vector<vtkChartXY*>& charts, int width, int height)
{
  const int count = static_cast<int>(charts.size());
  if (count == 0)
  {
    return;
  }
  const int columns = columnsFor(count, width, height);
  const int rows = rowsOf(count, columns);
  const float across = static_cast<float>(width) / static_cast<float>(columns);
  const float up = static_cast<float>(height) / static_cast<float>(rows);
  for (int i = 0; i < count; ++i)
  {
    const auto column = static_cast<float>(i % columns);
    const auto row = static_cast<float>(rows - 1 - i / columns);
    charts[static_cast<std::size_t>(i)]->SetSize(
      vtkRectf(column * across + Margin, row * up + Margin, std::max(across - 2.0F * Margin, 1.0F),
        std::max(up - 2.0F * Margin, 1.0F)));
  }
}
} // namespace palpate
