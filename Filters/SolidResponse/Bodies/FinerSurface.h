// SPDX-License-Identifier: BSD-3-Clause
#ifndef FinerSurface_h
#define FinerSurface_h

#include "Solids/Curves/ShapedResponse.h"
#include "SolidResponse/Bodies/FacingPoints.h"
#include "Contact/BodyMesh.h"

#include <vector>

class vtkPolyData;

namespace palpate
{
/// The scanned surface of a body, finer than the surface of its solid. The response of each point
/// follows from the nearby landmarks of the solid that face the same way, and from the curvature at
/// the point itself.
class FinerSurface
{
public:
  /// `surface` must have passed checkTriangles; `normals`: three per point. `solid`: the surface to
  /// which the landmarks' point numbers refer. `a`: largest contact radius for which the shape is
  /// needed, mm. All arguments must outlive this object.
  FinerSurface(vtkPolyData* surface, const float* normals, vtkPolyData* solid,
    const LandmarkKernels& landmarks, double a);

  /// Returns the data of the surface that the response of true shape needs. Valid as long as this
  /// object.
  LandmarkSurface view() const;

private:
  Vector3 normal(std::size_t i) const;
  LandmarkSpot spot(std::size_t i) const;
  EdgeSurroundings surroundings(
    std::int32_t i, const std::function<bool(std::int32_t)>& isValid) const;
  void findTurns();

  const LandmarkKernels& Landmarks;
  const float* Normals;
  BodyMesh Mesh;
  double Reach;           ///< radius to which a contact needs the surface, mm
  FacingPoints OnSurface; ///< all points
  std::vector<std::vector<std::size_t>> NearbyLandmarks; ///< landmarks around each point
  std::vector<float> Turns; ///< angle by which the surface turns at each point, rad
};
} // namespace palpate

#endif
