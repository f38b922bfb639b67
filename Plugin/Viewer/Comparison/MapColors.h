// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MapColors_h
#define palpate_MapColors_h

#include "vtkLookupTable.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>

class vtkPolyData;
class vtkRenderer;

namespace palpate
{
/// Returns colours from pale tissue to deep red, with grey for NaN. `range` is the range of the
/// values. `curve` is the exponent of the fraction of the range; with an exponent below 1, small
/// values are easier to distinguish.
vtkSmartPointer<vtkLookupTable> makeMapColors(const std::array<double, 2>& range, double curve);

/// Adds a body that is coloured by its point scalars, with a legend. `title` is the title of the
/// legend, with quantity and unit.
void addColoredBody(vtkPolyData* body, vtkLookupTable* colors, const std::string& title,
  const char* labelFormat, vtkRenderer* renderer);
} // namespace palpate

#endif
