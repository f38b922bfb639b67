// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_EdgeChains_h
#define palpate_EdgeChains_h

#include "Contact/LargePages.h"
#include "Contact/PackedMesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/**
 * The creases of a surface as chains along the borders of its faces, with a list of the chains near
 * each triangle.
 *
 * A chain follows the border of one face, counter-clockwise as seen from outside. It ends where the
 * border turns left by more than 30° (a corner of the face), where blunt and sharp edges meet, or
 * where the crease ends. At a corner of a face the next chain begins; there, each of the two chains
 * continues straight beyond the corner. An edge between two faces belongs to two chains, one for
 * each face.
 *
 * Built in O(n log n) on one thread. Memory: 4 bytes per triangle, and 32 bytes per triangle near a
 * chain. Immutable.
 */
class EdgeChains
{
public:
  static constexpr std::size_t MostNear = 8;
  static constexpr std::int32_t None = -1;
  /// Indices of segments, the nearest first; unused entries are None.
  using Near = std::array<std::int32_t, MostNear>;

  /// One edge of a triangle on a crease, in local coordinates of the mesh.
  struct Segment
  {
    Vector3 start;
    Vector3 along;   ///< unit vector
    Vector3 outward; ///< unit vector in the plane of the triangle
    Vector3 normal;  ///< unit normal of the triangle
    double length;
    std::int32_t next = None; ///< next segment of the chain
    std::int32_t previous = None;
    std::int32_t chain = None;
    std::int32_t face = None;  ///< the face that the segment bounds
    std::int32_t other = None; ///< the face on the other side
    std::int32_t across;       ///< the triangle on the other side
    bool isBlunt;
    bool turnsLeft = false; ///< whether the chain turns left at the next segment
    /// Whether the chain continues straight beyond a corner of the face at the segment's start.
    bool goesOnBefore = false;
    /// Whether the chain continues straight beyond a corner of the face at the segment's end.
    bool goesOnBehind = false;
    std::array<double, 2> sharpness; ///< see edgeSharpness(); at the start and the end
    /// Normal of the face on the other side, at the start and the end.
    std::array<Vector3, 2> otherNormal;
  };

  /// The closest point on a chain.
  struct Place
  {
    std::int32_t segment = None;
    double part = 0.0; ///< position on the segment as a fraction of its length
    Vector3 point = Vector3::Zero();
    double distance = 0.0; ///< mm, in the plane of the segment; positive on the side of the face
    /// Gradient of the distance with respect to the argument of closest().
    Vector3 gradient = Vector3::Zero();
  };

  /// Distance from a triangle, mm, within which a sharp or a blunt chain counts as near.
  struct Reach
  {
    double sharp;
    double blunt;
  };

  /// `poissonRatio` is Poisson's ratio of the body.
  EdgeChains(const PackedMesh& mesh, double poissonRatio, const Reach& reach);

  /// Returns the chains near a triangle; null if no crease is near it.
  const Near* near(std::int32_t triangle) const noexcept
  {
    const std::int32_t place =
      this->NearPlaces.empty() ? None : this->NearPlaces[static_cast<std::size_t>(triangle)];
    return place < 0 ? nullptr : &this->NearLists[static_cast<std::size_t>(place)];
  }
  /// Prefetches the memory that near() reads.
  void prefetch(std::int32_t triangle) const noexcept
  {
    if (!this->NearPlaces.empty())
    {
      prefetchLine(this->NearPlaces.data() + triangle);
    }
  }
  const Segment& segment(std::int32_t number) const noexcept
  {
    return this->Segments[static_cast<std::size_t>(number)];
  }

  /// Returns the local minimum of the distance between a point and a chain, searched from the
  /// segment `segment`. `place` is the point in local coordinates. The search stops after a fixed
  /// number of segments, so that its time is bounded.
  Place closest(const Vector3& place, std::int32_t segment) const noexcept;

  double reach() const noexcept { return this->Limits.sharp; }
  /// Returns the memory used, bytes.
  std::size_t memory() const noexcept;

private:
  void makeSegments(const PackedMesh& mesh, double poissonRatio);
  void linkSegments(const PackedMesh& mesh);
  void roundEnds();
  void findNear(const PackedMesh& mesh);
  Place closest(const Vector3& place, std::int32_t segment, std::size_t mostSteps) const noexcept;
  /// Returns the segment on an edge of a triangle, or None.
  std::int32_t segmentAt(std::int32_t triangle, int edge) const;

  Reach Limits;
  std::vector<Segment> Segments;
  std::vector<PackedMesh::CreaseSide> Sides; ///< used only during construction
  std::vector<std::int32_t> NearPlaces;
  std::vector<Near> NearLists;
};
} // namespace palpate

#endif
