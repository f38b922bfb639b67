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
 * Finds the contact point of a tip by a global search once, then follows the point from tick to
 * tick.
 *
 * The first contact is the globally closest point of the body, once the tip is inside the body. In
 * later ticks the contact is the local minimum of the distance that is reached from the last
 * triangle: the search crosses edges as long as the distance to the tip decreases. It stops when no
 * triangle that shares a corner with the current triangle is nearer, to the rounding error of
 * double arithmetic. A bound stored with each triangle proves this in most ticks
 * (PackedMesh::isCertainlyNearest); otherwise these triangles are checked. (It is not enough to
 * check only the triangles across the edges: under a convex pair of facets each facet has a local
 * minimum of the distance.)
 *
 * Therefore a tip that has passed the middle of a thin slab remains in contact with the side on
 * which it entered, like a god-object (Zilles and Salisbury 1995). The contact ends when the tip
 * leaves the body through this side; another contact may begin in the same tick. The contact also
 * ends beyond an open border, where its force has faded to 0 (BorderFade).
 *
 * On the smooth surface the local minimum is that of SmoothContact. The search for the first
 * contact starts from the closest point of the facets. The contact begins when the tip is inside
 * the smooth surface, which is slightly above convex facets and below concave ones. If the smooth
 * surface has no suitable point (see SmoothContact), the contact continues on the facets and
 * returns to the smooth surface as soon as there is such a point. At this change the force may jump
 * by the difference between the facets and the smooth surface.
 *
 * If the surface is cut along sharp edges (PackedMesh), a contact remains on its face. Beyond a
 * crease, the contact point is the closest point of the face until the caller ends the contact
 * (BodyEdges). No contact begins beyond a crease, because a tip whose closest point is on a convex
 * edge is outside.
 *
 * A tick neither allocates, locks nor throws. It takes at most MaximumSteps steps of about one
 * triangle each, that is 30 mm on a body of 0.2 mm triangles. If the tip moves farther, the whole
 * body is searched as for a new contact, because an intermediate point of the search is not a local
 * minimum and its distance is not a deflection. Each thread needs its own tracker. Trackers may
 * share mesh, tree and response, which must outlive them.
 */
class PALPATE_EXPORT ContactTracker
{
public:
  static constexpr int MaximumSteps = 256;

  enum class Outcome : std::uint8_t
  {
    Outside,
    Inside,
    Border, ///< under an open border, where inside and outside are not defined
    /// Under the plane of a face, beyond a crease at its border; only for a followed contact.
    Crease,
    Invalid ///< the tip is not finite, or the body has no usable triangle
  };

  /// Outcome and contact point of one tick.
  struct Result
  {
    Outcome outcome = Outcome::Outside;
    /// The contact point in the body's frame. Its normal and gradients are set on the smooth
    /// surface, and on facets that replace the smooth surface; otherwise they are not set.
    ContactPlace place;
  };

  /// Creates a tracker on the facets.
  ContactTracker(const PackedMesh& mesh, const TriangleTree& tree) noexcept
    : Mesh(mesh)
    , Tree(tree)
    , Search(tree)
  {
  }
  /// Creates a tracker on the smooth surface.
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

  /// Moves the contact to another triangle if the tip is inside under the face of that triangle.
  /// Otherwise changes nothing and returns an outcome other than Inside.
  Result handOver(const Vector3& tip, std::int32_t triangle) noexcept;

  /// Ends the contact; the next update searches the whole body.
  void reset() noexcept { this->Last.triangle = -1; }

  /// Returns the triangle of the last contact; -1 if there was none.
  std::int32_t triangle() const noexcept { return this->Last.triangle; }

  /// Predicts the triangle of the contact for a tip at `tip`, by a short walk over the faces
  /// without checks. Returns -1 if there is no contact.
  std::int32_t triangleAhead(const Vector3& tip) const noexcept;

  /// Returns the local minimum of the distance that is reached from a triangle, in the mesh's local
  /// frame. Its triangle is -1 if the search takes more than MaximumSteps steps.
  static SurfacePoint follow(
    const PackedMesh& mesh, const Vector3& tip, std::int32_t triangle) noexcept;

private:
  /// Handles most ticks: the tip is under the face of the last tick or at most three edges away
  /// from it, and certainly no neighbouring triangle is nearer. Otherwise returns false and changes
  /// nothing except `surface`.
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
  // The following functions use the mesh's local frame.
  /// Follows the last contact.
  Result goOn(const Vector3& tip) noexcept;
  /// Starts a contact at the closest point of the whole body.
  Result begin(const Vector3& tip) noexcept;
  /// Returns the contact on the smooth surface, searched from the point with area coordinates
  /// `weights`, or else the contact on the facets.
  Result touch(const Vector3& tip, std::int32_t triangle, const Vector3& weights) noexcept;
  bool isHeld(const Result& result, const Vector3& tip) const noexcept;

  const PackedMesh& Mesh;
  const TriangleTree& Tree;
  TriangleSearch Search; ///< search of the whole body; its cache only reduces the time
  std::optional<SmoothContact> Smooth; ///< empty if contacts are on the facets
  ContactPlace Last;                   ///< its triangle is -1 if there is no contact
  Vector3 Tip = Vector3::Zero(); ///< tip at the last contact, mm; used only on the smooth surface
};
} // namespace palpate

#endif
