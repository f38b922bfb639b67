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
/// Axis from 0 to the first tick that is not below `largest`, with at most `steps` of 1, 2 or 5
/// times a power of ten. VTK's own choice of ticks differs between versions. Returns the end of the
/// axis; 0, with the axis unchanged, unless `largest` is positive and finite.
double fitAxis(vtkAxis* axis, double largest, int steps = 8);

/// Axis from exactly -span to 0.
void fitAxisBefore(vtkAxis* axis, double span, int steps);

/// Axis of decades 10^first to 10^last, over logarithms to the base ten; it begins `below` earlier.
void fitLogAxis(vtkAxis* axis, int first, int last, double below = 0.0);

/// Title, title size and label size in points.
void styleAxis(vtkAxis* axis, const char* title, int titleSize, int labelSize);

/// Size of the title in points; and its text, "" for none, as VTK would put it on the frame.
void styleTitle(vtkChart* chart, int size);
void setTitle(vtkChart* chart, const std::string& title);

/// A pale area between the second and the third column of a table over its first, without a legend.
void addBand(vtkChart* chart, vtkTable* table, const Color& color);
} // namespace palpate

#endif
