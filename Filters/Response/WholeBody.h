// SPDX-License-Identifier: BSD-3-Clause
#ifndef WholeBody_h
#define WholeBody_h

#include "Response/BodyLaws.h"

#include "vtkSmartPointer.h"

namespace palpate
{
/// How a response includes the compliance of the body as a whole.
struct WholeBody
{
  vtkSmartPointer<vtkPolyData> body; ///< the body with the arrays of the compliance
  std::string heldAt;                ///< "": the compliance is not included
  std::string warning;               ///< why it is not included, or repairs of the surface; or ""
  bool isComplete = true;            ///< false after an abort
};

/**
 * Finds the compliance of the body of a request with `wholeBody` (BodyYield), attaches it to a copy
 * of the body, and adds the array to the request. The body is left as it is if it is open, on
 * several processes, or known better: if it has layers, a given compliance, a material that varies
 * or was measured, or a Poisson's ratio above 0.499. The same applies if sharp edges have an effect
 * (a law of their own), and if contacts interact (the compliance of one does not act on another). It is also left as it is, with a warning, if
 * it cannot be filled or held or if the module Solids is missing.
 */
WholeBody includeWholeBody(const Ranks& ranks, vtkPolyData* body,
  const std::function<bool(double)>& goOn, LawRequest& request);
} // namespace palpate

#endif
