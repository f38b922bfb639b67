// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SmoothTracker_h
#define palpate_SmoothTracker_h

#include "Contact/ContactTracker.h"
#include "Mechanics/PalpateExport.h"
#include "Contact/SmoothContact.h"
#include "Contact/TriangleSearch.h"
#include "Contact/TriangleTree.h"

namespace palpate
{
/**
 * Where the tip touches the smooth surface, tick after tick: a ContactTracker whose closest points
 * are those of SmoothContact.
 *
 * The first contact starts from the closest point of the facets, and begins where the tip is inside
 * the smooth surface, which lies a little above convex facets and below concave ones. From then on
 * the local minimum of the distance is followed. Where there is no smooth point (see
 * SmoothContact), the contact goes on with the facets from there, and returns as soon as there is
 * one; the force may jump at such a change, by what facets and surface differ.
 *
 * The tick neither allocates nor locks nor throws. One tracker serves one thread; mesh, tree and
 * response may be shared and must outlive it.
 */
class PALPATE_EXPORT SmoothTracker
{
public:
  /// Where a tip stands.
  struct Contact
  {
    ContactTracker::Outcome outcome = ContactTracker::Outcome::Outside;
    ContactPlace place; ///< its point in the body's frame
  };

  SmoothTracker(
    const PackedMesh& mesh, const TriangleTree& tree, const ResponseField& response) noexcept
    : Mesh(mesh)
    , Tree(tree)
    , Search(tree)
    , Smooth(mesh, response)
  {
  }

  Contact update(const Vector3& tip) noexcept;

  /// Forgets the contact; the next update searches the whole body.
  void reset() noexcept { this->Last.triangle = -1; }

  /// Of the last contact, -1 if there was none.
  std::int32_t triangle() const noexcept { return this->Last.triangle; }

private:
  Contact touch(const Vector3& tip, std::int32_t triangle, const Vector3& weights) noexcept;
  Contact search(const Vector3& tip) noexcept;

  const PackedMesh& Mesh;
  const TriangleTree& Tree;
  TriangleSearch Search; ///< of the whole body; what it has seen saves time and changes nothing
  SmoothContact Smooth;
  ContactPlace Last;             ///< triangle -1: no contact
  Vector3 Tip = Vector3::Zero(); ///< then
};
} // namespace palpate

#endif
