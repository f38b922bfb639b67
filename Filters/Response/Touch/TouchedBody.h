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
/// The law's validity at a place: that of the triangle's corner with the smallest depth.
struct PlaceValidity
{
  bool known = false; ///< whether the response has the arrays Validity and Limit
  double depth = 0.0; ///< depth at which the first assumption fails, mm
  std::string limit;  ///< name of that assumption; "" if none fails
  /// Estimated relative error of the force; NaN if the response stores none.
  double error = std::numeric_limits<double>::quiet_NaN();
};

/// A body with a response, for the display of a touch: finds the nearest place and evaluates the
/// stored curves there. Stores the body, and a locator of its triangles that is made on first use.
class TouchedBody
{
public:
  TouchedBody();
  ~TouchedBody();
  TouchedBody(const TouchedBody&) = delete;
  TouchedBody& operator=(const TouchedBody&) = delete;

  /// Returns false and names the missing part if the body does not have the response `name`.
  bool take(vtkPolyData* body, const std::string& name, std::string& error);

  /// The nearest place of the surface; cell -1 for a body without triangles.
  TouchedPlace nearest(const Vector3& tip);
  /// The first intersection of the surface with a segment; cell -1 if they do not meet.
  TouchedPlace hit(const Vector3& from, const Vector3& to);
  /// The place of a surface point in a cell of the body.
  TouchedPlace placeIn(vtkIdType cell, const Vector3& point) const;

  /// Unit normal of the facet, on the side of the response's normals.
  Vector3 normal(const TouchedPlace& place) const;
  /// Whether all corners have a response.
  bool isValid(const TouchedPlace& place) const;
  /// Bounds of the body: smallest and largest x, y, z, mm.
  const double* bounds() const;

  /// Depth of the last sample at the place, mm; 0 without a response.
  double range(const TouchedPlace& place) const;
  /// Blended dF/dδ of the three corners' curves, N/mm.
  double stiffness(const TouchedPlace& place, double depth) const;
  /// The law's validity at the place for a deflection, mm.
  PlaceValidity validity(const TouchedPlace& place, double depth) const;

  /// Force at half of Range, averaged over the points that have a response, N. O(points).
  double typicalForce() const;

private:
  bool locate();

  vtkSmartPointer<vtkPolyData> Body;
  vtkSmartPointer<vtkPolyData> Triangles; ///< the triangles of the body, without other cells
  vtkSmartPointer<vtkStaticCellLocator> Locator;
  std::string Name;
  ResponseArrays Response;
};

/// The prefixes of the responses of a body, 'A', 'B'; "" if it has none.
std::string listResponses(vtkPolyData* body);
} // namespace palpate

#endif
