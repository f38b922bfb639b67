// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactTracker_h
#define palpate_ContactTracker_h

#include "Contact/PackedMesh.h"
#include "Contact/SmoothContact.h"
#include "Mechanics/PalpateExport.h"
#include "Contact/TriangleTree.h"

#include <cmath>
#include <cstdint>
#include <optional>

namespace palpate
{
/**
 * Where the tip touches, tick after tick: found globally once, then followed.
 *
 * The first contact is the globally closest point of the body, once the tip is inside. From then on
 * the contact is the local minimum of the distance reached from the last triangle: it moves across
 * the edge towards the tip while that is nearer, and stops at a point to which no triangle that
 * shares a corner with its own is nearer, to the rounding of double arithmetic. That last is
 * certain from a bound stored with each triangle (PackedMesh::isCertainlyNearest), or tried out.
 * (Stopping where no triangle across an edge is nearer would not do: under a convex pair of facets
 * each has such a point.)
 *
 * So a tip that has passed the middle of a thin slab stays in contact with the side it entered, as
 * a god-object would (Zilles and Salisbury 1995). The contact ends when the tip passes the surface
 * outward there (and another may begin in the same tick), or beyond an open border, where nothing
 * is left of its force (BorderFade).
 *
 * On the smooth surface the local minimum is that of SmoothContact. The first contact starts from
 * the closest point of the facets, and begins where the tip is inside the smooth surface, which
 * lies a little above convex facets and below concave ones. Where there is no smooth point (see
 * SmoothContact), the contact goes on with the facets from there, and returns as soon as there is
 * one; the force may jump at such a change, by what facets and surface differ.
 *
 * Where the surface is cut along sharp edges (PackedMesh), a contact stays on its face: beyond a
 * crease it is held at its closest point until the caller lets go (BodyEdges). None begins there,
 * since a tip whose closest point is on a convex edge is outside.
 *
 * The tick neither allocates nor locks nor throws. Steps per tick are bounded by MaximumSteps, a
 * step being about one triangle: 30 mm on a body of 0.2 mm triangles. A tip that outruns them is
 * searched for in the whole body, as a new contact is: a point on the way there would be no local
 * minimum, and its distance no deflection. One tracker serves one thread; mesh, tree
 * and response may be shared and must outlive it.
 */
class PALPATE_EXPORT ContactTracker
{
public:
  static constexpr int MaximumSteps = 256;

  enum class Outcome : std::uint8_t
  {
    Outside,
    Inside,
    Border, ///< under an open border: there is no inside there
    Crease, ///< under a face, beyond a crease that bounds it; only while followed
    Invalid ///< the tip is not finite, or the body has no usable triangle
  };

  /// Where a tip stands.
  struct Result
  {
    Outcome outcome = Outcome::Outside;
    /// Its point in the body's frame. Of facets without normal and gradients, unless they stand in
    /// for the smooth surface.
    ContactPlace place;
  };

  /// On the facets.
  ContactTracker(const PackedMesh& mesh, const TriangleTree& tree) noexcept
    : Mesh(mesh)
    , Tree(tree)
    , Search(tree)
  {
  }
  /// On the smooth surface.
  ContactTracker(
    const PackedMesh& mesh, const TriangleTree& tree, const ResponseField& response) noexcept
    : ContactTracker(mesh, tree)
  {
    this->Smooth.emplace(mesh, response);
  }

  Result update(const Vector3& tip) noexcept
  {
    Result result;
    if (this->Smooth || !this->staysOnFaces(tip, result.place))
    {
      return this->search(tip);
    }
    result.outcome = Outcome::Inside;
    return result;
  }

  /// Goes on from another triangle, if the tip is inside under its face: else nothing changes, and
  /// the result is another than Inside.
  Result handOver(const Vector3& tip, std::int32_t triangle) noexcept;

  /// Forgets the contact; the next update searches the whole body.
  void reset() noexcept { this->Last.triangle = -1; }

  /// Of the last contact, -1 if there was none.
  std::int32_t triangle() const noexcept { return this->Last.triangle; }

  /// Under which triangle the contact will likely be when the tip is there: by a short walk over
  /// faces, on which nothing is certain. -1 without a contact.
  std::int32_t triangleAhead(const Vector3& tip) const noexcept;

  /// Local minimum of the distance reached from a triangle, in the mesh's local frame; triangle -1
  /// if that takes more than MaximumSteps.
  static SurfacePoint follow(
    const PackedMesh& mesh, const Vector3& tip, std::int32_t triangle) noexcept;

private:
  /// Most ticks: the tip is under the face it was under, or one a few edges on, and it is certain
  /// that nothing around is nearer. False, and nothing is changed but `surface`, where it is not so
  /// or cannot be told this way.
  bool staysOnFaces(const Vector3& tip, SurfacePoint& surface) noexcept
  {
    constexpr int crossings = 3;
    const Vector3 local = this->Mesh.toLocal(tip);
    std::int32_t triangle = this->Tree.isBeyondHorizon(local) ? -1 : this->Last.triangle;
    PlaneFoot foot = PlaneFoot::Unknown;
    for (int i = 0; i <= crossings && triangle >= 0; ++i)
    {
      foot = this->Mesh.projectOnFace(local, triangle, surface.projection);
      if (foot == PlaneFoot::OnFace || foot == PlaneFoot::Unknown)
      {
        break;
      }
      triangle = this->Mesh.neighbour(triangle, static_cast<int>(foot));
    }
    if (triangle < 0 || foot != PlaneFoot::OnFace ||
      !this->Mesh.isCertainlyNearest(local, triangle, surface.projection))
    {
      return false;
    }
    this->Last.triangle = triangle;
    surface.triangle = triangle;
    surface.signedDistance = -std::sqrt(surface.projection.squaredDistance);
    surface.projection.point += this->Mesh.centre();
    return true;
  }
  Result search(const Vector3& tip) noexcept;
  // All in the mesh's local frame:
  /// From the last contact.
  Result goOn(const Vector3& tip) noexcept;
  /// From the closest point of the whole body.
  Result begin(const Vector3& tip) noexcept;
  /// On the smooth surface from a point of it, or on the facets.
  Result touch(const Vector3& tip, std::int32_t triangle, const Vector3& weights) noexcept;
  bool isHeld(const Result& result, const Vector3& tip) const noexcept;

  const PackedMesh& Mesh;
  const TriangleTree& Tree;
  TriangleSearch Search; ///< of the whole body; what it has seen saves time and changes nothing
  std::optional<SmoothContact> Smooth; ///< else on the facets
  ContactPlace Last;                   ///< triangle -1: no contact
  Vector3 Tip = Vector3::Zero();       ///< then; only if smooth
};
} // namespace palpate

#endif
