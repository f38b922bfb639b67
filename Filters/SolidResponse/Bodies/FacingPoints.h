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
/// Points of a surface from which its arrays are interpolated to places nearby. Only points that
/// face the same way are used, so that no value crosses a thin lobe.
class PALPATESOLIDRESPONSE_EXPORT FacingPoints
{
public:
  /// Takes the points for which `isTaken` is true. The surface must consist of triangles.
  FacingPoints(vtkPolyData* surface, const std::function<bool(vtkIdType)>& isTaken);

  bool isEmpty() const { return this->Ids.empty(); }

  /// Ids and weights (sum 1) of the six nearest points whose normals are within 60° of `normal`,
  /// weighted by 1/distance², the nearest first. Returns fewer points if the surface has fewer, and
  /// none if no point faces that way. Safe from any number of threads.
  std::vector<std::pair<vtkIdType, double>> around(
    const double place[3], const Vector3& normal) const;

  /// Like around(), but returns only wanted points (empty function: all points). Searches the 24
  /// nearest points. If these include fewer than three wanted points, the 192 nearest points are
  /// searched.
  std::vector<std::pair<vtkIdType, double>> nearBy(const double place[3], const Vector3& normal,
    const std::function<bool(vtkIdType)>& isWanted = {}) const;

private:
  using Weights = std::vector<std::pair<vtkIdType, double>>;
  Weights find(int search, const double place[3], const Vector3& normal,
    const std::function<bool(vtkIdType)>& isWanted) const;

  std::vector<vtkIdType> Ids; ///< ids of the points on the surface
  std::vector<Vector3> Normals;
  vtkSmartPointer<vtkPolyData> Cloud;
  vtkSmartPointer<vtkStaticPointLocator> Locator;
};
} // namespace palpate

#endif
