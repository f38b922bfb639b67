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
    Border,  ///< on an open border, beyond which the distance would decrease further
    Crease,  ///< on a crease, beyond which the distance would decrease further
    NotFound ///< no such point here: use the facets
  };

  Outcome outcome = Outcome::NotFound;
  ContactPlace place; ///< not set if NotFound
};

/**
 * The true closest point of the smooth surface of a body: one SmoothTriangle per triangle, through
 * the points of the mesh and perpendicular to the normals of the response.
 *
 * follow() descends by Newton's method from a nearby point (that of the last tick) to the local
 * minimum of the distance, and moves to the neighbour if the minimum is beyond an edge. As the
 * surface is G1, point, normal and distance are continuous in the tip as long as the depth of the
 * tip is less than the surface's radius of convex curvature. The weights are continuous too,
 * because the two triangles of an edge agree on it. With H the Hessian of half the squared distance
 * by the parameters α of the patch, the parameters move with the tip by H⁻¹ ∂P/∂α (implicit
 * function theorem).
 *
 * In the following cases the result is NotFound, and the caller uses the closest point of the
 * facet: if the depth of the tip is within about a thousandth of the radius of curvature, or larger
 * than this radius (det H <= FocalShare times its value at the surface: the closest point is about
 * to split in two), at a crease (see SmoothTriangle), on a folded triangle (see PackedMesh), at a
 * seam of triangles without area, and after MaximumSteps.
 *
 * A step costs about 0.1 µs, the patch of a new triangle 0.2 µs; a tick takes two or three steps.
 * follow() neither allocates nor locks nor throws. It stores the last patch: one SmoothContact
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

  /// Starts from area coordinates of a triangle of the mesh with the sum 1; the point may be beyond
  /// the edges. If the tip is not finite, the result is NotFound.
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
