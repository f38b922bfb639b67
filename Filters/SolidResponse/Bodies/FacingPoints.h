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
/// Points of a surface from which its arrays are interpolated to nearby positions. Only points with
/// a similar normal are used, so that no value is taken from the opposite side of a thin lobe.
class PALPATESOLIDRESPONSE_EXPORT FacingPoints
{
public:
  /// Takes the points for which `isTaken` returns true. The surface must consist of triangles.
  FacingPoints(vtkPolyData* surface, const std::function<bool(vtkIdType)>& isTaken);

  bool isEmpty() const { return this->Ids.empty(); }

  /// Returns the ids and the weights of the six nearest points whose normals are within 60° of
  /// `normal`, the nearest first. The weights are proportional to 1/distance² and have the sum 1.
  /// Fewer points are returned if the surface has fewer such points. Thread-safe.
  std::vector<std::pair<vtkIdType, double>> around(
    const double place[3], const Vector3& normal) const;

  /// Same as around(), but returns only points for which `isWanted` returns true; an empty function
  /// accepts all points. Searches the 24 nearest points. If fewer than three of these are accepted,
  /// searches the 192 nearest points.
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
