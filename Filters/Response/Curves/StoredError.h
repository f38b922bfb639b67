// SPDX-License-Identifier: BSD-3-Clause
#ifndef StoredError_h
#define StoredError_h

#include "palpateResponseModule.h" // For export macro

#include "vtkType.h"

#include <string>

class vtkPolyData;

namespace palpate
{
/// Estimated relative error of a point's force at a depth (mm), from the response's array Error:
/// straight over √δ between its samples, as it was found, and below the first what it is there. NaN
/// where the response keeps none, or beyond its range.
PALPATERESPONSE_EXPORT double storedError(
  vtkPolyData* body, const std::string& responseName, vtkIdType point, double depth);

/// What to write behind a force: " ± 4 %"; from 100 % on that nothing is known; "" of NaN.
PALPATERESPONSE_EXPORT std::string errorInWords(double relativeError);
} // namespace palpate

#endif
