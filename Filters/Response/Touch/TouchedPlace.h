// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * A place where a body is or can be touched.
 */
#ifndef TouchedPlace_h
#define TouchedPlace_h

#include "Contact/TriangleProjection.h" // For palpate::Vector3

#include "vtkType.h" // For vtkIdType

namespace palpate
{
/// A place on the surface of a body.
struct TouchedPlace
{
  vtkIdType cell = -1;               ///< cell of the body; -1 if there is no place
  Vector3 point = Vector3::Zero();   ///< position, mm
  Vector3 weights = Vector3::Zero(); ///< area coordinates of the three corners
  double distance = 0.0;             ///< distance from the given point to this place, mm
};
} // namespace palpate

#endif
