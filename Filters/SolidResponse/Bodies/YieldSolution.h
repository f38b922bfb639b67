// SPDX-License-Identifier: BSD-3-Clause
#ifndef YieldSolution_h
#define YieldSolution_h

#include "Response/Bodies/BodyYield.h"

class vtkAlgorithm;

namespace palpate
{
/// Returns "", or a message that names the wrong setting of a request.
std::string checkYieldRequest(const YieldRequest& request);

/// Reads the solution of a body from the cache, or solves for it and stores it there. `body` must
/// be the body() of a SoundBody. Reports progress to `filter`, and stops if it is aborted: the
/// result is then empty. Returns "", or a message about the fault.
std::string solveYield(
  vtkPolyData* body, const YieldRequest& request, vtkAlgorithm* filter, BodyYield& made);
} // namespace palpate

#endif
