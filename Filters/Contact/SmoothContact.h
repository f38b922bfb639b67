// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SmoothContact_h
#define palpate_SmoothContact_h

#include "Contact/Contact.h"
#include "Contact/PackedMesh.h"
#include "Mechanics/PalpateExport.h"
#include "Contact/ResponseField.h"
#include "Contact/SmoothTriangle.h"

#include <cstdint>

namespace palpate
{
/// The closest point of the smooth surface. Local coordinates of the mesh.
struct SmoothPoint
{
  enum class Outcome : std::uint8_t
  {
    Found,
    Border,  ///< on an open border, beyond which the distance would go on to fall
    Crease,  ///< likewise where the surface is cut along a sharp edge
    NotFound ///< no such point here: take the facets
  };

  Outcome outcome = Outcome::NotFound;
  ContactPlace place; ///< unless NotFound
};

/**
 * The true closest point of the smooth surface of a body: one SmoothTriangle per triangle, through
 * the points of the mesh and perpendicular to the normals of the response.
 *
 * follow() descends by Newton's method from a point nearby, that of the last tick, to the local
 * minimum of the distance, and walks to the neighbour where that lies beyond an edge. As the
 * surface is G1, the point, the normal and the distance are continuous in the tip as long as it is
 * less deep than the surface's radius of convex curvature; the weights are too, because an edge
 * belongs to both of its triangles alike. With H the Hessian of half the squared distance by the
 * parameters α of the patch, the parameters move with the tip by H⁻¹ ∂P/∂α (implicit function
 * theorem).
 *
 * NotFound, for the caller to take the facet's own point instead: within about a thousandth of the
 * radius of curvature or deeper (det H <= FocalShare of what it is at the surface: the closest
 * point is about to part in two), at a crease (see SmoothTriangle), at a seam of triangles without
 * area, and after MaximumSteps.
 *
 * A step costs some 0.1 µs, the patch of a new triangle 0.2 µs; a tick takes two or three steps.
 * follow() neither allocates nor locks nor throws. It keeps the last patch: one SmoothContact
 * serves one thread. Mesh and response may be shared and must outlive it.
 */
class PALPATE_EXPORT SmoothContact
{
public:
  static constexpr int MaximumSteps = 64;
  static constexpr double FocalShare = 1e-3;

  SmoothContact(const PackedMesh& mesh, const ResponseField& response) noexcept
    : Mesh(mesh)
    , Response(response)
  {
  }

  /// From area coordinates of a triangle of the mesh, sum 1; they may lie beyond its edges. A tip
  /// that is not finite is not found.
  SmoothPoint follow(const Vector3& tip, std::int32_t triangle, const Vector3& weights) noexcept;

private:
  class Descent;
  bool load(std::int32_t triangle) noexcept;

  const PackedMesh& Mesh;
  const ResponseField& Response;
  SmoothTriangle Patch;
  std::int32_t Loaded = -1;
  bool IsSound = false;
};
} // namespace palpate

#endif
