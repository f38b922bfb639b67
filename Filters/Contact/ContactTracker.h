// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactTracker_h
#define palpate_ContactTracker_h

#include "BodyMesh.h"
#include "TriangleTree.h"

#include <cstdint>

namespace palpate
{
/**
 * Where the tip touches, tick after tick: found globally once, then followed.
 *
 * The first contact is the globally closest point of the body, once the tip is inside. From then on
 * the contact is the local minimum of the distance reached from the last triangle, each step
 * choosing the best of all triangles that share a corner with the current one. So a tip that has
 * passed the middle of a thin slab stays in contact with the side it entered, as a god-object would
 * (Zilles and Salisbury 1995). The contact ends when the tip passes the surface outward there (and
 * another may begin in the same tick), or when the projection reaches an open border.
 *
 * The tick neither allocates nor locks nor throws. Steps per tick are bounded by MaximumSteps; a
 * tip so fast that this is not enough is followed further in the next tick. One tracker serves one
 * thread; mesh and tree may be shared and must outlive it.
 */
class ContactTracker
{
public:
  static constexpr int MaximumSteps = 256;

  enum class Outcome : std::uint8_t
  {
    Outside,
    Inside,
    Border, ///< under an open border: there is no inside there
    Invalid ///< the tip is not finite, or the body has no usable triangle
  };

  struct Contact
  {
    Outcome outcome = Outcome::Outside;
    SurfacePoint surface;
  };

  ContactTracker(const BodyMesh& mesh, const TriangleTree& tree) noexcept
    : Mesh(mesh)
    , Tree(tree)
  {
  }

  Contact update(const Vector3& tip) noexcept;

  /// Forgets the contact; the next update searches the whole body.
  void reset() noexcept { this->Triangle = -1; }

  /// Local minimum of the distance reached from a triangle.
  static SurfacePoint follow(
    const BodyMesh& mesh, const Vector3& tip, std::int32_t triangle) noexcept;

private:
  const BodyMesh& Mesh;
  const TriangleTree& Tree;
  std::int32_t Triangle = -1; ///< of the last tick's contact, -1 if there was none
};
} // namespace palpate

#endif
