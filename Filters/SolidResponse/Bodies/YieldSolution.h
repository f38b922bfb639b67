// SPDX-License-Identifier: BSD-3-Clause
#ifndef YieldSolution_h
#define YieldSolution_h

#include "Response/Bodies/BodyYield.h"

class vtkAlgorithm;

namespace palpate
{
/// Returns "", or a message that names the wrong setting of a request.
std::string checkYieldRequest(const YieldRequest& request);

/// Reads the solution of a body from the cache. If it is not there, solves the body and stores the
/// solution. `body` must be the body() of a SoundBody. Reports progress to `filter`; if `filter` is
/// aborted, the work stops and the result is empty. Returns "", or a message about the fault.
std::string solveYield(
  vtkPolyData* body, const YieldRequest& request, vtkAlgorithm* filter, BodyYield& made);
} // namespace palpate

#endif
