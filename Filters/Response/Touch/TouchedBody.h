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
/// Validity of the law at a place, taken from the corner of the triangle with the smallest
/// validity.
struct PlaceValidity
{
  bool known = false; ///< whether the response has the arrays Validity and Limit
  double depth = 0.0; ///< depth at which the first assumption fails, mm
  std::string limit;  ///< name of that assumption; "" if no assumption fails
  /// Estimated relative error of the force. It is NaN if the response stores no error.
  double error = std::numeric_limits<double>::quiet_NaN();
};

/// A body with a response, used to display a touch. The object finds the nearest place and
/// evaluates the stored curves there. It stores the body, and a locator of the body's triangles
/// that is built on first use.
class TouchedBody
{
public:
  TouchedBody();
  ~TouchedBody();
  TouchedBody(const TouchedBody&) = delete;
  TouchedBody& operator=(const TouchedBody&) = delete;

  /// Sets the body. Returns false, with an error that names the missing part, if the body does not
  /// have the response `name`.
  bool take(vtkPolyData* body, const std::string& name, std::string& error);

  /// Returns the nearest place of the surface; its cell is -1 for a body without triangles.
  TouchedPlace nearest(const Vector3& tip);
  /// Returns the first intersection of the surface with a segment. Its cell is -1 if there is no
  /// intersection.
  TouchedPlace hit(const Vector3& from, const Vector3& to);
  /// Returns the place of the surface point `point` in the cell `cell` of the body.
  TouchedPlace placeIn(vtkIdType cell, const Vector3& point) const;

  /// Returns the unit normal of the facet. It points to the same side of the surface as the normals
  /// of the response.
  Vector3 normal(const TouchedPlace& place) const;
  /// Returns whether all corners of the triangle have a response.
  bool isValid(const TouchedPlace& place) const;
  /// Returns the bounds of the body: smallest and largest x, y, z, mm.
  const double* bounds() const;

  /// Returns the depth of the last sample at the place, mm; 0 if the place has no response.
  double range(const TouchedPlace& place) const;
  /// Returns the blended dF/dδ of the curves at the three corners, N/mm.
  double stiffness(const TouchedPlace& place, double depth) const;
  /// Returns the validity of the law at the place, and the error at the deflection `depth`, mm.
  PlaceValidity validity(const TouchedPlace& place, double depth) const;

  /// Returns the force at half of Range, averaged over the points that have a response, N. The cost
  /// is O(points).
  double typicalForce() const;

private:
  bool locate();

  vtkSmartPointer<vtkPolyData> Body;
  vtkSmartPointer<vtkPolyData> Triangles; ///< the triangles of the body, without other cells
  vtkSmartPointer<vtkStaticCellLocator> Locator;
  std::string Name;
  ResponseArrays Response;
};

/// Returns the prefixes of the responses of a body as text, such as "'A', 'B'"; "" if the body has
/// no response.
std::string listResponses(vtkPolyData* body);
} // namespace palpate

#endif
