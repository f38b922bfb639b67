// SPDX-License-Identifier: BSD-3-Clause
#ifndef ChartStyle_h
#define ChartStyle_h

#include "Interaction/Display/DisplayColors.h"

#include <string>

class vtkAxis;
class vtkChart;
class vtkTable;

namespace palpate
{
/// Sets the range of an axis from 0 to the first tick that is not below `largest`. There are at
/// most `steps` steps, of 1, 2 or 5 times a power of ten. (VTK's own choice of ticks differs
/// between versions.) Returns the end of the axis. If `largest` is not positive and finite, returns
/// 0 and leaves the axis unchanged.
double fitAxis(vtkAxis* axis, double largest, int steps = 8);

/// Sets the range of an axis to exactly -span to 0, with `steps` steps.
void fitAxisBefore(vtkAxis* axis, double span, int steps);

/// Sets an axis whose values are decimal logarithms. Its ticks are the decades 10^first to 10^last.
/// The axis begins at `first` - `below`.
void fitLogAxis(vtkAxis* axis, int first, int last, double below = 0.0);

/// Sets the title of an axis, and the sizes of the title and of the labels in points.
void styleAxis(vtkAxis* axis, const char* title, int titleSize, int labelSize);

/// styleTitle sets the size of the title in points. setTitle sets its text; "" means no title.
/// Without these functions, VTK would draw the title over the frame.
void styleTitle(vtkChart* chart, int size);
void setTitle(vtkChart* chart, const std::string& title);

/// Adds a pale area between the second and the third column of a table, plotted over the first
/// column. If `label` is "", the area has no entry in the legend.
void addBand(vtkChart* chart, vtkTable* table, const Color& color, const std::string& label);

/// Label in the legend for the error band of a curve.
extern const char* const BandLabel;
} // namespace palpate

#endif
