// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FacingPoints_h
#define palpate_FacingPoints_h

#include "Contact/TriangleProjection.h" // For palpate::Vector3

#include "palpateSolidResponseModule.h" // For export macro
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

class vtkPolyData;
class vtkStaticPointLocator;

namespace palpate
{
/// Points of a surface from which its arrays are interpolated to places nearby, using only points
/// that face the same way, so that nothing crosses a thin lobe.
class PALPATESOLIDRESPONSE_EXPORT FacingPoints
{
public:
  /// The points with these ids; the surface consists of triangles.
  FacingPoints(vtkPolyData* surface, const std::function<bool(vtkIdType)>& isTaken);

  bool isEmpty() const { return this->Ids.empty(); }

  /// Ids and weights, which sum to 1: the six nearest whose normals lie within 60° of `normal`, by
  /// 1/distance², the nearest first; fewer if there are no more, none if none faces that way. From
  /// any number of threads.
  std::vector<std::pair<vtkIdType, double>> around(
    const double place[3], const Vector3& normal) const;

  /// The same of the wanted ones alone (empty: all): those among the 24 nearest points, if three or
  /// more, otherwise those among the 192 nearest.
  std::vector<std::pair<vtkIdType, double>> nearBy(const double place[3], const Vector3& normal,
    const std::function<bool(vtkIdType)>& isWanted = {}) const;

private:
  using Weights = std::vector<std::pair<vtkIdType, double>>;
  Weights find(int search, const double place[3], const Vector3& normal,
    const std::function<bool(vtkIdType)>& isWanted) const;

  std::vector<vtkIdType> Ids; ///< on the surface
  std::vector<Vector3> Normals;
  vtkSmartPointer<vtkPolyData> Cloud;
  vtkSmartPointer<vtkStaticPointLocator> Locator;
};
} // namespace palpate

#endif
