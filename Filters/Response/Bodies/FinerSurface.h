// SPDX-License-Identifier: BSD-3-Clause
#ifndef FinerSurface_h
#define FinerSurface_h

#include "Laws/ShapedResponse.h"
#include "Response/Bodies/FacingPoints.h"
#include "Contact/BodyMesh.h"

#include <vector>

class vtkPolyData;

namespace palpate
{
/// The surface of a body as it was scanned, whose solid is coarser: each point is felt from the
/// landmarks around it on the solid that face the same way, curved as it is itself.
class FinerSurface
{
public:
  /// `surface` has passed checkTriangles and has three `normals` per point; `solid` is the surface
  /// that the landmarks number. Its shape is asked for up to a contact radius `a` (mm). All must
  /// stay.
  FinerSurface(vtkPolyData* surface, const float* normals, vtkPolyData* solid,
    const LandmarkKernels& landmarks, double a);

  /// As a law asks for it; this must stay.
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
  double Reach;                                 ///< mm
  FacingPoints OnSolid;                         ///< landmarks alone
  FacingPoints AllOfSolid;                      ///< to tell what is held
  FacingPoints OnSurface;                       ///< all points
  std::vector<std::vector<std::size_t>> Around; ///< landmarks of each point
  std::vector<float> Turns; ///< at each point by which the surface turns away, rad
};
} // namespace palpate

#endif
