// SPDX-License-Identifier: BSD-3-Clause
#ifndef ChartLayout_h
#define ChartLayout_h

#include <vector>

class vtkChartXY;

namespace palpate
{
/// Shares out a viewport among charts, row by row from the top left: in so many columns that they
/// become as large as they can at a pleasant shape.
void layOut(const std::vector<vtkChartXY*>& charts, int width, int height);
} // namespace palpate

#endif
