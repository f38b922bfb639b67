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
  /// The body, with the arrays of the compliance if it is included.
  vtkSmartPointer<vtkPolyData> body;
  std::string heldAt; ///< Sides at which the body is held; "" if the compliance is not included.
  /// Reason why the compliance is not included, or a repair of the surface; "" if there is neither.
  std::string warning;
  bool isComplete = true; ///< false if the work was aborted
};

/**
 * Finds the compliance of a body whose request has `wholeBody` set (BodyYield). Attaches the
 * compliance to a copy of the body, and adds the array of the compliance to the request.
 *
 * The compliance is not included, and `body` is returned unchanged, in these cases: the surface is
 * open; the body is on several processes; the body has layers, a given compliance, a material that
 * varies or was measured, or a Poisson's ratio above 0.499; contacts interact, because the
 * compliance under one contact does not act on another contact; the triangles are too large for an
 * accurate compliance (isAccurate). The compliance is also not included, and a warning is returned,
 * if the body cannot be filled with elements or held, or if the module Solids is missing.
 */
WholeBody includeWholeBody(const Ranks& ranks, vtkPolyData* body,
  const std::function<bool(double)>& goOn, LawRequest& request);
} // namespace palpate

#endif
