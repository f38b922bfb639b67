// SPDX-License-Identifier: BSD-3-Clause
#ifndef CoarserBody_h
#define CoarserBody_h

#include "Solids/TrueShape/MeshDifference.h"
#include "SolidResponse/Bodies/SolvedBody.h"

#include <memory>
#include <string>

namespace palpate
{
/// Checks that `coarser` can be the same body as `grid` with coarser cells. Returns "" or an error
/// message that names the input.
std::string checkCoarser(vtkUnstructuredGrid* grid, vtkUnstructuredGrid* coarser);

/// A body with coarser cells. It is solved in addition to the body with finer cells, to estimate
/// the error due to the length of the finer elements. Both bodies are kept for the next tool.
class CoarserBody
{
public:
  /// Solves the missing parts of the request for the coarser body, and compares it with `body`.
  /// `body` must be solved for the same request. The memory limit is reduced by the memory of
  /// `body`. Adds the cost of the coarser body to `cost`. On entry, cost.solutions is the number of
  /// solutions of `body`; if it is not 0, `body` is new. Returns "" or an error message.
  std::string compare(vtkUnstructuredGrid* coarser, const SolveRequest& request, SolvedBody& body,
    const FilterStage& stage, SolveCost& cost);

  /// Returns the difference of the two bodies; null before compare().
  const MeshDifference* difference() const { return this->Difference.get(); }

private:
  SolvedBody Body;
  std::unique_ptr<MeshDifference> Difference;
};
} // namespace palpate

#endif
