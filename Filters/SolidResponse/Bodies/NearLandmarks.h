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

/// Search for the landmarks of a solid around places of a surface that is close to it.
class NearLandmarks
{
public:
  /// `solid`: the surface to which the landmarks' point numbers refer. Both arguments must outlive
  /// this object.
  NearLandmarks(vtkPolyData* solid, const LandmarkKernels& landmarks);

  /// Indices in LandmarkKernels::points() of the landmarks that face the same way, the nearest
  /// first. Empty if the place is in the held part of the solid. Safe from any number of threads.
  std::vector<std::size_t> around(const double place[3], const Vector3& normal) const;

private:
  const LandmarkKernels& Landmarks;
  FacingPoints OnSolid; ///< landmarks only
  HeldPlaces Held;      ///< held part of the solid
};
} // namespace palpate

#endif
