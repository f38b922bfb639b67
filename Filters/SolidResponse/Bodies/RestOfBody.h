// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RestOfBody_h
#define palpate_RestOfBody_h

#include "Solids/FiniteElements/UnitLoads.h"
#include "SolidResponse/Bodies/FactorisedBody.h"

#include "vtkNew.h"
#include "vtkStaticCellLocator.h"
#include "vtkUnstructuredGrid.h"

#include <string>
#include <vector>

class vtkGenericCell;

namespace palpate
{
/// A body in coarse cells, from which a part is cut out that a tool is pressed on: how its places
/// move with loads on that.
class RestOfBody
{
public:
  /// Factorises the grid, which must stay. Returns what is wrong, or "". `memory` (MiB) as of
  /// factoriseBody().
  std::string factorise(vtkUnstructuredGrid* grid, const FactorRequest& request,
    const std::function<bool(double)>& goOn, double& memory, bool& ended);

  const ElasticBody& body() const { return this->Body; }

  /// The mean distance of its surface's points, mm: half the length of quadratic cells.
  double spacing() const;

  /// The nearest of its surface's points that face the same way as an outward normal; -1: none.
  std::int32_t pointBeside(const Eigen::Vector3d& place, const Eigen::Vector3d& normal) const;

  /// How those of the places move that are asked for, under unit loads at a place of the surface;
  /// the others stay. `inward` (mm): a little way into the body there. Empty where memory is short.
  /// From any number of threads.
  UnitMotion motionAt(const Eigen::Vector3d& place, const Eigen::Vector3d& inward,
    const Eigen::Matrix3Xd& places, const std::vector<unsigned char>& asked) const;

private:
  /// The closest place of the body, and the shapes of its element's nodes there.
  ElementPlace locate(
    const Eigen::Vector3d& place, vtkGenericCell* cell, std::vector<double>& shapes) const;

  ElasticBody Body;
  vtkNew<vtkUnstructuredGrid> Grid;
  vtkNew<vtkStaticCellLocator> Locator;
};
} // namespace palpate

#endif
