// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/CoarserBody.h"

#include "Mechanics/Checked.h"
#include "Mechanics/JoinedText.h"

#include "vtkGenericCell.h"
#include "vtkNew.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double LeastRatio = 1.2; // smallest ratio of the edge lengths of the two bodies' cells
// Largest shift of the bounding box's sides, in lengths of coarser cells.
constexpr double LargestShift = 2.0;
// Smallest memory limit, MiB; a limit of 0 would mean all available memory.
constexpr double LeastMemory = 1e-3;
constexpr double SolvedPart = 0.7;
constexpr double FittedPart = 0.95; // fractions of the work at the end of two steps in compare()

/// Returns the mean diagonal of a grid's cells.
double lengthOfCells(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkGenericCell> cell;
  double sum = 0.0;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    grid->GetCell(i, cell);
    sum += std::sqrt(cell->GetLength2());
  }
  return sum / static_cast<double>(grid->GetNumberOfCells());
}
} // namespace

std::string checkCoarser(vtkUnstructuredGrid* grid, vtkUnstructuredGrid* coarser)
{
  if (coarser->GetNumberOfCells() == 0)
  {
    return "Wrong input: Coarser has no cells";
  }
  const double length = lengthOfCells(coarser);
  const double ratio = length / lengthOfCells(grid);
  if (!(ratio >= LeastRatio))
  {
    return joined("Wrong input: Coarser must have cells at least ", LeastRatio,
      " times as long as the body's, but its cells are ", ratio, " times as long");
  }
  std::array<double, 6> box{};
  std::array<double, 6> other{};
  grid->GetBounds(box.data());
  coarser->GetBounds(other.data());
  for (std::size_t side = 0; side < box.size(); ++side)
  {
    const double shift = std::abs(box[side] - other[side]);
    if (!(shift <= LargestShift * length))
    {
      return joined("Wrong input: Coarser is not the same body: ", "xyz"[side / 2], " ends at ",
        other[side], " mm instead of ", box[side], ", more than ", LargestShift,
        " of its cells apart");
    }
  }
  return {};
}

std::string CoarserBody::compare(vtkUnstructuredGrid* coarser, const SolveRequest& request,
  SolvedBody& body, const FilterStage& stage, SolveCost& cost)
{
  const auto at = [&stage](double part) { return stage.from + part * (stage.to - stage.from); };
  SolveRequest same = request;
  same.radius = std::max(request.radius, body.green().radius());
  if (request.factor.memoryLimit > 0.0)
  {
    same.factor.memoryLimit = std::max(LeastMemory, request.factor.memoryLimit - body.memory());
  }
  SolveCost own;
  const std::string fault =
    this->Body.solve(coarser, same, FilterStage{ stage.filter, stage.from, at(SolvedPart) }, own);
  const bool isNew = cost.solutions > 0 || own.solutions > 0;
  cost.memory += own.memory;
  cost.solutions += own.solutions;
  cost.ended = own.ended;
  if (isNew || !fault.empty() || own.ended)
  {
    this->Difference.reset();
  }
  if (!fault.empty() || own.ended || this->Difference)
  {
    return prefixed("Coarser: ", fault);
  }
  const LandmarkKernels* fine =
    body.landmarks(FilterStage{ stage.filter, at(SolvedPart), at(FittedPart) });
  const LandmarkKernels* coarse =
    fine ? this->Body.landmarks(FilterStage{ stage.filter, at(FittedPart), stage.to }) : nullptr;
  cost.ended = !coarse;
  if (coarse)
  {
    this->Difference = std::make_unique<MeshDifference>(*fine, *coarse);
  }
  return {};
}
} // namespace palpate
