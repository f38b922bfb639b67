// SPDX-License-Identifier: BSD-3-Clause
#ifndef ColorLegend_h
#define ColorLegend_h

#include "Interaction/Display/DisplayColors.h"

#include <array>

class vtkLookupTable;
class vtkScalarBarActor;

namespace palpate
{
/// The colours, blended.
void fillColors(vtkLookupTable* table, const std::array<Color, 5>& colors);

/// A slim bar with its title and five numbers, `fontSize` points.
void styleLegend(vtkScalarBarActor* legend, vtkLookupTable* table, const char* title, int fontSize);
} // namespace palpate

#endif
