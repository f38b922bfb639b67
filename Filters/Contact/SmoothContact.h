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
/// The closest point of the smooth surface, in local coordinates of the mesh.
struct SmoothPoint
{
  enum class Outcome : std::uint8_t
  {
    Found,
    Border,  ///< the point is on an open border, beyond which the distance would decrease further
    Crease,  ///< the point is on a crease, beyond which the distance would decrease further
    NotFound ///< the smooth surface has no suitable point: the caller must use the facets
  };

  Outcome outcome = Outcome::NotFound;
  ContactPlace place; ///< not set if NotFound
};

/**
 * Finds the closest point of the smooth surface of a body. This surface has one SmoothTriangle per
 * triangle. It passes through the points of the mesh and is perpendicular to the normals of the
 * response.
 *
 * follow() descends by Newton's method from a nearby point (that of the last tick) to the local
 * minimum of the distance, and moves to the neighbouring triangle if the minimum is beyond an edge.
 * As the surface is G1, the closest point, its normal and the distance are continuous functions of
 * the tip's position as long as the depth of the tip is less than the surface's radius of convex
 * curvature. The weights are continuous too, because the two triangles of an edge have the same
 * weights on it. Let H be the Hessian of half the squared distance with respect to the parameters α
 * of the patch. If the tip moves, the parameters move by H⁻¹ ∂P/∂α times the displacement of the
 * tip (implicit function theorem).
 *
 * The result is NotFound, and the caller uses the closest point of the facet, in the following
 * cases: the depth of the tip is close to the radius of curvature (within about a thousandth) or
 * larger than this radius, so that the closest point is about to split in two (det H <= FocalShare
 * times its value at the surface); the point is at a crease (see SmoothTriangle), on a folded
 * triangle (see PackedMesh) or at a seam of triangles without area; the search exceeds
 * MaximumSteps.
 *
 * A step costs about 0.1 µs, the patch of a new triangle 0.2 µs; a tick takes two or three steps.
 * follow() neither allocates, locks nor throws. The object stores the last patch, so that each
 * thread needs its own object. Objects may share mesh and response, which must outlive them.
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

  /// Starts from the area coordinates `weights` of a point of a triangle of the mesh. Their sum is
  /// 1; the point may be beyond the edges. If the tip is not finite, the result is NotFound.
  SmoothPoint follow(const Vector3& tip, std::int32_t triangle, const Vector3& weights) noexcept;

private:
  class Descent;
  bool isFlat(std::int32_t triangle) const noexcept;
  bool load(std::int32_t triangle) noexcept;

  const PackedMesh& Mesh;
  const ResponseField& Response;
  SmoothTriangle Patch;
  std::int32_t Loaded = -1;
  bool IsSound = false;
};
} // namespace palpate

#endif
