// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FacingPoints_h
#define palpate_FacingPoints_h

#include "Contact/TriangleProjection.h" // For palpate::Vector3

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <functional>
#include <utility>
#include <vector>

class vtkPolyData;
class vtkStaticPointLocator;

namespace palpate
{
/// Points of a surface from which its arrays are interpolated to places nearby, of those alone that
/// face the same way: nothing crosses a thin lobe.
class FacingPoints
{
public:
  /// The points with these ids; the surface consists of triangles.
  FacingPoints(vtkPolyData* surface, const std::function<bool(vtkIdType)>& isTaken);

  bool isEmpty() const { return this->Ids.empty(); }

  /// Ids and weights, which sum to 1: the six nearest whose normals lie within 60° of `normal`, by
  /// 1/distance²; fewer if there are no more, none if none faces that way.
  std::vector<std::pair<vtkIdType, double>> around(
    const double place[3], const Vector3& normal) const;

private:
  std::vector<vtkIdType> Ids; ///< on the surface
  std::vector<Vector3> Normals;
  vtkSmartPointer<vtkPolyData> Cloud;
  vtkSmartPointer<vtkStaticPointLocator> Locator;
};
} // namespace palpate

#endif
