// SPDX-License-Identifier: BSD-3-Clause
#ifndef NearLandmarks_h
#define NearLandmarks_h

#include "SolidResponse/Bodies/FacingPoints.h"
#include "SolidResponse/Bodies/HeldPlaces.h"

#include <cstddef>
#include <vector>

class vtkPolyData;

namespace palpate
{
class LandmarkKernels;

/// Search for the landmarks of a solid around positions on a surface that is close to the solid.
class NearLandmarks
{
public:
  /// `solid` is the surface to which the point numbers of the landmarks refer. Both arguments must
  /// outlive this object.
  NearLandmarks(vtkPolyData* solid, const LandmarkKernels& landmarks);

  /// Returns the indices in LandmarkKernels::points() of nearby landmarks with a similar normal,
  /// the nearest first. The result is empty if `place` is in the held part of the solid.
  /// Thread-safe.
  std::vector<std::size_t> around(const double place[3], const Vector3& normal) const;

private:
  const LandmarkKernels& Landmarks;
  FacingPoints OnSolid; ///< landmarks on the surface of the solid
  HeldPlaces Held;      ///< held part of the solid
};
} // namespace palpate

#endif
