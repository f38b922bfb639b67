// SPDX-License-Identifier: BSD-3-Clause
#ifndef WholeBody_h
#define WholeBody_h

#include "Response/BodyLaws.h"

#include "vtkSmartPointer.h"

namespace palpate
{
/// Result of includeWholeBody.
struct WholeBody
{
  vtkSmartPointer<vtkPolyData> body; ///< the body with the arrays of the compliance
  std::string heldAt; ///< sides at which the body is held; "": the compliance is not included
  /// Reason why the compliance is not included, or a repair of the surface; "" if neither.
  std::string warning;
  bool isComplete = true; ///< false after an abort
};

/**
 * Finds the compliance of the body of a request with `wholeBody` (BodyYield), attaches it to a copy
 * of the body, and adds the array to the request.
 *
 * The compliance is not included, and `body` is returned unchanged, in these cases: the surface is
 * open; the body is on several processes; it has layers, a given compliance, a material that varies
 * or was measured, or a Poisson's ratio above 0.499; contacts interact (the compliance under one
 * contact does not act on another); the triangles are too large for it (isAccurate). The same
 * holds, with a warning, if the body cannot be filled with elements or held, or if the module
 * Solids is missing.
 */
WholeBody includeWholeBody(const Ranks& ranks, vtkPolyData* body,
  const std::function<bool(double)>& goOn, LawRequest& request);
} // namespace palpate

#endif
