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
 * The creases of a surface as chains that bound its faces, and the chains near each triangle.
 *
 * A chain follows the border of one face, counter-clockwise seen from outside. It ends where the
 * border turns left by more than 30° (the corner of a face), where blunt and sharp edges meet, or
 * where the crease ends. At a corner of a face the next chain begins, and each of the two continues
 * straight beyond the corner. At an edge between two faces, each face has a separate chain.
 *
 * Built in O(n log n) on one thread. Memory: 4 bytes per triangle, and 32 per triangle near a
 * chain. Immutable.
 */
class EdgeChains
{
public:
  static constexpr std::size_t MostNear = 8;
  static constexpr std::int32_t None = -1;
  using Near = std::array<std::int32_t, MostNear>; ///< segments, the nearest first, then None

  /// A side of a facet. Local coordinates of the mesh.
  struct Segment
  {
    Vector3 start;
    Vector3 along;   ///< unit
    Vector3 outward; ///< unit, in the plane of its triangle
    Vector3 normal;  ///< unit, of that triangle
    double length;
    std::int32_t next = None; ///< next segment of the chain
    std::int32_t previous = None;
    std::int32_t chain = None;
    std::int32_t face = None;  ///< the face that the segment bounds
    std::int32_t other = None; ///< the face on the other side
    std::int32_t across;       ///< the triangle on the other side
    bool isBlunt;
    bool turnsLeft = false;    ///< whether the chain turns left at the next segment
    bool goesOnBefore = false; ///< continues straight beyond a corner of the face at its start
    bool goesOnBehind = false; ///< continues straight beyond a corner of the face at its end
    std::array<double, 2> sharpness;    ///< at both ends, see edgeSharpness
    std::array<Vector3, 2> otherNormal; ///< normal of the other side, at both ends
  };

  /// The closest point on a chain.
  struct Place
  {
    std::int32_t segment = None;
    double part = 0.0; ///< fraction of the segment's length
    Vector3 point = Vector3::Zero();
    double distance = 0.0; ///< mm, in the plane of the segment, > 0 on the side of the face
    Vector3 gradient = Vector3::Zero(); ///< gradient of the distance by the argument of closest()
  };

  /// Distance from a triangle (mm) within which a chain counts as near.
  struct Reach
  {
    double sharp;
    double blunt;
  };

  /// `poissonRatio` is that of the body.
  EdgeChains(const PackedMesh& mesh, double poissonRatio, const Reach& reach);

  /// The chains near a triangle; null if there is no crease near it.
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

  /// The local minimum of the distance along a chain, searched from one of its segments. `place` is
  /// in local coordinates. The time is bounded: the search stops after a fixed number of segments.
  Place closest(const Vector3& place, std::int32_t segment) const noexcept;

  double reach() const noexcept { return this->Limits.sharp; }
  /// Bytes held.
  std::size_t memory() const noexcept;

private:
  void makeSegments(const PackedMesh& mesh, double poissonRatio);
  void linkSegments(const PackedMesh& mesh);
  void roundEnds();
  void findNear(const PackedMesh& mesh);
  Place closest(const Vector3& place, std::int32_t segment, std::size_t mostSteps) const noexcept;
  /// The segment on an edge of a triangle, or None.
  std::int32_t segmentAt(std::int32_t triangle, int edge) const;

  Reach Limits;
  std::vector<Segment> Segments;
  std::vector<PackedMesh::CreaseSide> Sides; ///< only while the object is built
  std::vector<std::int32_t> NearPlaces;
  std::vector<Near> NearLists;
};
} // namespace palpate

#endif
