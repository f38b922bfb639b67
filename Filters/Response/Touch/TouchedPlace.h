// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A place where a tool touches or can touch a body.
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
  vtkIdType cell = -1;             ///< cell of the body; -1 if there is no place
  Vector3 point = Vector3::Zero(); ///< position, mm
  /// Area coordinates of the place with respect to the three corners.
  Vector3 weights = Vector3::Zero();
  double distance = 0.0; ///< distance from the given point to this place, mm
};
} // namespace palpate

#endif
