// SPDX-License-Identifier: BSD-3-Clause
#ifndef SourceSpacing_h
#define SourceSpacing_h

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

namespace palpate
{
/// Name of the field array of a volume with the SourceSpacing of responses on this volume, mm.
constexpr const char* SourceSpacingName = "SourceSpacing";

/// Returns the SourceSpacing of a response, mm. It is `given` unless `given` is 0. Otherwise it is
/// the value of the volume's field array, or 0 if the volume has none.
inline double sourceSpacing(vtkUnstructuredGrid* volume, double given)
{
  vtkDataArray* own = volume->GetFieldData()->GetArray(SourceSpacingName);
  const bool isKnown = own && own->GetNumberOfValues() == 1 && own->GetTuple1(0) > 0.0 &&
    std::isfinite(own->GetTuple1(0));
  return given == 0.0 && isKnown ? own->GetTuple1(0) : given;
}
} // namespace palpate

#endif
