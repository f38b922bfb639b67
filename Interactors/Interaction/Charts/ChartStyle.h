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
/// Sets an axis from 0 to the first tick that is not below `largest`, with at most `steps` steps of
/// 1, 2 or 5 times a power of ten. (VTK's own choice of ticks differs between versions.) Returns
/// the end of the axis. If `largest` is not positive and finite, returns 0 and leaves the axis
/// unchanged.
double fitAxis(vtkAxis* axis, double largest, int steps = 8);

/// Sets an axis from exactly -span to 0.
void fitAxisBefore(vtkAxis* axis, double span, int steps);

/// Sets an axis of the decades 10^first to 10^last for values that are logarithms to the base ten.
/// It begins `below` before `first`.
void fitLogAxis(vtkAxis* axis, int first, int last, double below = 0.0);

/// Sets the title of an axis, and the sizes of title and labels in points.
void styleAxis(vtkAxis* axis, const char* title, int titleSize, int labelSize);

/// Sets the size of the title in points, and its text ("" for none). VTK alone would put the text
/// on the frame.
void styleTitle(vtkChart* chart, int size);
void setTitle(vtkChart* chart, const std::string& title);

/// Adds a pale area between the second and the third column of a table over its first column; "":
/// without an entry in the legend.
void addBand(vtkChart* chart, vtkTable* table, const Color& color, const std::string& label);

/// Entry in the legend for a band around a curve.
extern const char* const BandLabel;
} // namespace palpate

#endif
