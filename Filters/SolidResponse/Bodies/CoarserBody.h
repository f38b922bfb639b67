// SPDX-License-Identifier: BSD-3-Clause
#ifndef CoarserBody_h
#define CoarserBody_h

#include "Solids/TrueShape/MeshDifference.h"
#include "SolidResponse/Bodies/SolvedBody.h"

#include <memory>
#include <string>

namespace palpate
{
/// Why a grid cannot be the same body in coarser cells, naming the input, or "".
std::string checkCoarser(vtkUnstructuredGrid* grid, vtkUnstructuredGrid* coarser);

/// A body in coarser cells, solved beside another to tell what the elements of that miss. Kept from
/// one tool to the next, as that is.
class CoarserBody
{
public:
  /// Solves it, within what `body` leaves of the memory limit, for what the request needs and
  /// compares it with `body`, which has been solved for the same: what of that is not there yet.
  /// Adds to the cost, whose solutions tell whether the body is new. Returns what is wrong, or "".
  std::string compare(vtkUnstructuredGrid* coarser, const SolveRequest& request, SolvedBody& body,
    const FilterStage& stage, SolveCost& cost);

  /// Null before.
  const MeshDifference* difference() const { return this->Difference.get(); }

private:
  SolvedBody Body;
  std::unique_ptr<MeshDifference> Difference;
};
} // namespace palpate

#endif
