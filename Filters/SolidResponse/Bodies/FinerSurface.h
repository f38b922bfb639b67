// SPDX-License-Identifier: BSD-3-Clause
#ifndef FinerSurface_h
#define FinerSurface_h

#include "Solids/Curves/ShapedResponse.h"
#include "SolidResponse/Bodies/FacingPoints.h"
#include "SolidResponse/Bodies/HeldPlaces.h"
#include "Contact/BodyMesh.h"

#include <vector>

class vtkPolyData;

namespace palpate
{
/// The scanned surface of a body whose solid is coarser: each point takes its response from the
/// landmarks around it on the solid that face the same way, with its own curvature.
class FinerSurface
{
public:
  /// `surface` has passed checkTriangles and has three `normals` per point; `solid` is the surface
  /// that the landmarks number. Its shape is needed up to a contact radius `a` (mm). All arguments
  /// must outlive this.
  FinerSurface(vtkPolyData* surface, const float* normals, vtkPolyData* solid,
    const LandmarkKernels& landmarks, double a);

  /// The view that a law needs; valid as long as this.
  LandmarkSurface view() const;

private:
  Vector3 normal(std::size_t i) const;
  LandmarkSpot spot(std::size_t i) const;
  std::vector<std::size_t> landmarksAround(std::size_t i) const;
  EdgeSurroundings surroundings(
    std::int32_t i, const std::function<bool(std::int32_t)>& isValid) const;
  void findTurns();

  const LandmarkKernels& Landmarks;
  const float* Normals;
  BodyMesh Mesh;
  double Reach;                                 ///< of the surface that a contact sees, mm
  FacingPoints OnSolid;                         ///< landmarks alone
  HeldPlaces Held;                              ///< of the solid
  FacingPoints OnSurface;                       ///< all points
  std::vector<std::vector<std::size_t>> Around; ///< landmarks of each point
  std::vector<float> Turns;                     ///< of the surface at each point, rad
};
} // namespace palpate

#endif
