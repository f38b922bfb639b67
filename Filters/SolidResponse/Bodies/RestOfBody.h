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
/// A body in coarse cells, from which the part under a tool is cut out. This class computes the
/// motion of the body under loads on that part.
class RestOfBody
{
public:
  /// Factorises the grid, which must outlive this object. Returns "", or a message about the fault.
  /// `memory` (MiB) as in factoriseBody().
  std::string factorise(vtkUnstructuredGrid* grid, const FactorRequest& request,
    const std::function<bool(double)>& goOn, double& memory, bool& ended);

  const ElasticBody& body() const { return this->Body; }

  /// Mean distance of neighbouring surface points, mm. This is half the length of quadratic cells.
  double spacing() const;

  /// The nearest point of the surface whose normal is within 90° of the given outward `normal`; -1
  /// if there is no such point.
  std::int32_t nearestPoint(const Eigen::Vector3d& place, const Eigen::Vector3d& normal) const;

  /// Computes the motion of `places` under unit loads at a place of the surface. Only places with
  /// `asked` set are computed; the motion of the others is 0. `inward` (mm): a small step into the
  /// body at the place. The result is empty if there is not enough memory. Safe from any number of
  /// threads.
  UnitMotion motionAt(const Eigen::Vector3d& place, const Eigen::Vector3d& inward,
    const Eigen::Matrix3Xd& places, const std::vector<unsigned char>& asked) const;

private:
  /// The closest place of the body, and the shape functions of its element there.
  ElementPlace locate(
    const Eigen::Vector3d& place, vtkGenericCell* cell, std::vector<double>& shapes) const;

  ElasticBody Body;
  vtkNew<vtkUnstructuredGrid> Grid;
  vtkNew<vtkStaticCellLocator> Locator;
};
} // namespace palpate

#endif
