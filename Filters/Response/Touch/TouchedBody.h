// SPDX-License-Identifier: BSD-3-Clause
#ifndef TouchedBody_h
#define TouchedBody_h

#include "Contact/ResponseField.h" // For palpate::ResponseArrays
#include "Response/Touch/TouchedPlace.h"

#include "vtkSmartPointer.h" // For vtkSmartPointer
#include "vtkType.h"         // For vtkIdType

#include <limits>
#include <string>

class vtkPolyData;
class vtkStaticCellLocator;

namespace palpate
{
/// The law's validity at a place: the least of the corners.
struct PlaceValidity
{
  bool known = false; ///< whether the response has the arrays
  double depth = 0.0; ///< at which the first assumption breaks, mm
  std::string limit;  ///< which, in words; "" for none
  /// Estimated relative error of the force; NaN where the response keeps none.
  double error = std::numeric_limits<double>::quiet_NaN();
};

/// A body with a response, for the display of a touch: its nearest place, and the stored curves
/// there. Holds the body, and a locator of its triangles made on first use.
class TouchedBody
{
public:
  TouchedBody();
  ~TouchedBody();
  TouchedBody(const TouchedBody&) = delete;
  TouchedBody& operator=(const TouchedBody&) = delete;

  /// False, and what is missing, if the body does not have the response `name`.
  bool take(vtkPolyData* body, const std::string& name, std::string& error);

  /// The nearest place of the surface; cell -1 for a body without triangles.
  TouchedPlace nearest(const Vector3& tip);
  /// The first intersection of the surface with a segment; cell -1 for none.
  TouchedPlace hit(const Vector3& from, const Vector3& to);
  /// The place of a point of the surface in a cell of the body.
  TouchedPlace placeIn(vtkIdType cell, const Vector3& point) const;

  /// Unit normal of the facet, on the side of the response's normals.
  Vector3 normal(const TouchedPlace& place) const;
  /// Whether all corners have a response.
  bool isValid(const TouchedPlace& place) const;
  /// Bounds of the body: least and largest x, y, z, mm.
  const double* bounds() const;

  /// Depth of the last sample there, mm; 0 without a response.
  double range(const TouchedPlace& place) const;
  /// dF/dδ of the three corners' curves, blended, N/mm.
  double stiffness(const TouchedPlace& place, double depth) const;
  /// The law's validity there at a deflection, mm.
  PlaceValidity validity(const TouchedPlace& place, double depth) const;

  /// Force at half of Range, on average over the points that have a response, N. O(points).
  double typicalForce() const;

private:
  bool locate();

  vtkSmartPointer<vtkPolyData> Body;
  vtkSmartPointer<vtkPolyData> Triangles; ///< those of the body, and no other cells
  vtkSmartPointer<vtkStaticCellLocator> Locator;
  std::string Name;
  ResponseArrays Response;
};

/// The prefixes of the responses of a body, 'A', 'B'; "" for none.
std::string listResponses(vtkPolyData* body);
} // namespace palpate

#endif
