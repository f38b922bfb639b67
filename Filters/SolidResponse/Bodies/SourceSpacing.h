// SPDX-License-Identifier: BSD-3-Clause
#ifndef SourceSpacing_h
#define SourceSpacing_h

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

namespace palpate
{
/// Name of the field array of a volume that gives the SourceSpacing of its responses, mm.
constexpr const char* SourceSpacingName = "SourceSpacing";

/// The SourceSpacing of a response, mm: `given` unless it is 0, else that of the volume, else 0.
inline double sourceSpacing(vtkUnstructuredGrid* volume, double given)
{
  vtkDataArray* own = volume->GetFieldData()->GetArray(SourceSpacingName);
  const bool isKnown = own && own->GetNumberOfValues() == 1 && own->GetTuple1(0) > 0.0 &&
    std::isfinite(own->GetTuple1(0));
  return given == 0.0 && isKnown ? own->GetTuple1(0) : given;
}
} // namespace palpate

#endif
