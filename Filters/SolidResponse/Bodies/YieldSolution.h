// SPDX-License-Identifier: BSD-3-Clause
#ifndef YieldSolution_h
#define YieldSolution_h

#include "Response/Bodies/BodyYield.h"

class vtkAlgorithm;

namespace palpate
{
/// Returns "", or an error message that names the invalid setting of a request.
std::string checkYieldRequest(const YieldRequest& request);

/// Reads the solution of a body from the cache. If the cache does not contain it, solves the body
/// and stores the solution. `body` must be the body() of a SoundBody. Reports progress to `filter`.
/// If `filter` is aborted, the work stops and the result is empty. Returns "" or an error message.
std::string solveYield(
  vtkPolyData* body, const YieldRequest& request, vtkAlgorithm* filter, BodyYield& made);
} // namespace palpate

#endif
