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
/// A body with coarse cells. The part under a tool is cut out of this body. The class computes the
/// motion of the body under loads on the part.
class RestOfBody
{
public:
  /// Factorises the grid, which must outlive this object. Returns "" or an error message. `memory`
  /// (MiB) and `ended` are those of factoriseBody().
  std::string factorise(vtkUnstructuredGrid* grid, const FactorRequest& request,
    const std::function<bool(double)>& goOn, double& memory, bool& ended);

  const ElasticBody& body() const { return this->Body; }

  /// Returns the mean distance of neighbouring surface points, mm. This is half the length of
  /// quadratic cells.
  double spacing() const;

  /// Returns the point of the surface nearest to `place` whose normal is within 90° of the outward
  /// normal `normal`. Returns -1 if there is no such point.
  std::int32_t nearestPoint(const Eigen::Vector3d& place, const Eigen::Vector3d& normal) const;

  /// Computes the motion of the positions `places` under unit loads at the position `place` of the
  /// surface. Only positions for which `asked` is set are computed; the motion of the others is 0.
  /// `inward` (mm) is a small step from `place` into the body. The result is empty if there is not
  /// enough memory. Thread-safe.
  UnitMotion motionAt(const Eigen::Vector3d& place, const Eigen::Vector3d& inward,
    const Eigen::Matrix3Xd& places, const std::vector<unsigned char>& asked) const;

private:
  /// Returns the closest position in the body, and the shape functions of its element at this
  /// position.
  ElementPlace locate(
    const Eigen::Vector3d& place, vtkGenericCell* cell, std::vector<double>& shapes) const;

  ElasticBody Body;
  vtkNew<vtkUnstructuredGrid> Grid;
  vtkNew<vtkStaticCellLocator> Locator;
};
} // namespace palpate

#endif
