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
/// The scanned surface of a body, which is finer than the surface of the body's solid. The response
/// at each point follows from the nearby landmarks of the solid that have a similar normal, and
/// from the curvature of the surface at the point.
class FinerSurface
{
public:
  /// `surface` must have passed checkTriangles. `normals` has three numbers per point. `solid` is
  /// the surface to which the point numbers of the landmarks refer. `a` is the largest contact
  /// radius for which the shape is needed, mm. All arguments must outlive this object.
  FinerSurface(vtkPolyData* surface, const float* normals, vtkPolyData* solid,
    const LandmarkKernels& landmarks, double a);

  /// Returns the surface data that the response of the true shape needs. The data are valid as long
  /// as this object.
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
  double Reach;           ///< radius within which a contact needs the surface, mm
  FacingPoints OnSurface; ///< all points of the surface
  /// Landmarks around each point of the surface.
  std::vector<std::vector<std::size_t>> NearbyLandmarks;
  /// Angle by which the normal of the surface varies around each point, rad.
  std::vector<float> Turns;
};
} // namespace palpate

#endif
