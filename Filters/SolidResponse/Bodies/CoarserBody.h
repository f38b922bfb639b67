// SPDX-License-Identifier: BSD-3-Clause
#ifndef CoarserBody_h
#define CoarserBody_h

#include "Solids/TrueShape/MeshDifference.h"
#include "SolidResponse/Bodies/SolvedBody.h"

#include <memory>
#include <string>

namespace palpate
{
/// Checks that `coarser` can be the same body as `grid` in coarser cells. Returns "", or a message
/// that names the input.
std::string checkCoarser(vtkUnstructuredGrid* grid, vtkUnstructuredGrid* coarser);

/// A body in coarser cells. It is solved in addition to the body in finer cells, to find the error
/// due to the finer elements. Both bodies are kept for the next tool.
class CoarserBody
{
public:
  /// Solves the missing parts of the request for the coarser body and compares it with `body`,
  /// which must be solved for the same request. The memory limit is reduced by the memory of
  /// `body`. Adds its cost to `cost`. On entry cost.solutions is the number of solutions of `body`;
  /// it shows whether `body` is new. Returns "", or a message about the fault.
  std::string compare(vtkUnstructuredGrid* coarser, const SolveRequest& request, SolvedBody& body,
    const FilterStage& stage, SolveCost& cost);

  /// Null before compare().
  const MeshDifference* difference() const { return this->Difference.get(); }

private:
  SolvedBody Body;
  std::unique_ptr<MeshDifference> Difference;
};
} // namespace palpate

#endif
