// SPDX-License-Identifier: BSD-3-Clause
#ifndef DeflectionLegend_h
#define DeflectionLegend_h

class vtkLookupTable;
class vtkScalarBarActor;

namespace palpate
{
/// DeflectionColors, blended, for the length of a displacement.
void fillDeflectionColors(vtkLookupTable* table);

/// A slim bar with its title and five numbers, `fontSize` points.
void styleDeflectionLegend(vtkScalarBarActor* legend, vtkLookupTable* colors, int fontSize);
} // namespace palpate

#endif
