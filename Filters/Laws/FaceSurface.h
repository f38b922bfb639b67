// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FaceSurface_h
#define palpate_FaceSurface_h

#include "Laws/LinkedSurface.h"
#include "Laws/SurfaceCurvature.h"
#include "Laws/SurfaceForms.h"
#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// A surface that is cut along its sharp edges (CreaseCut). A point on an edge has one copy for
/// each face at the edge, with the normal of that face. The copies are appended to the given
/// points.
class FaceSurface
{
public:
  /// `normals` has 3 floats per point, unit length.
  FaceSurface(const TriangleSpans& surface, const float* normals);

  TriangleSpans spans() const
  {
    return { this->Points.data(), this->PointOf.size(), this->Triangles.data(),
      this->Triangles.size() / 3 };
  }
  const std::vector<float>& normals() const noexcept { return this->Normals; }
  /// Returns the given point from which `point` was copied. A given point is returned unchanged.
  std::int32_t pointOf(std::size_t point) const noexcept { return this->PointOf[point]; }

private:
  void cut(const LinkedSurface& surface);
  void findNormals(const LinkedSurface& surface);

  std::vector<double> Points;
  std::vector<std::int32_t> Triangles;
  std::vector<float> Normals;
  std::vector<std::int32_t> PointOf;
  std::vector<bool> IsCut; ///< whether each point is on a sharp edge
};

/// The curvature of the faces between sharp edges (CreaseCut), for contacts that leave the body
/// over these edges (BodyEdges), and for any number of contact radii. The angle at an edge does not
/// count as curvature. At a point on an edge the mean over its faces is used. Does not refer to the
/// arrays after construction.
class PALPATE_EXPORT FaceForms
{
public:
  /// `normals` has 3 floats per point, unit length.
  FaceForms(const TriangleSpans& surface, const float* normals);

  SurfaceCurvature curvature(double contactRadius) const;

private:
  const std::size_t Points;
  const FaceSurface Faces;
  const SurfaceForms Forms;
};
} // namespace palpate

#endif
