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
 * The creases of a surface as the chains that bound its faces, and which of them are near each
 * triangle.
 *
 * A chain goes along the border of one face, counter-clockwise seen from outside, up to where that
 * turns left by more than 30° (the corner of a face: another chain begins there, and each goes on
 * straight beyond it) or where the crease ends. Where two faces meet, each has a chain of its own.
 *
 * Built in O(n log n) on one thread; 4 bytes a triangle and 32 for those within reach. Immutable.
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
    Vector3 normal;  ///< of that
    double length;
    std::int32_t next = None; ///< of the chain
    std::int32_t previous = None;
    std::int32_t chain = None;
    std::int32_t face = None;  ///< that it bounds
    std::int32_t other = None; ///< on the other side
    std::int32_t across;       ///< the triangle on the other side
    bool isBlunt;
    bool turnsLeft = false;             ///< to the next
    bool goesOnBefore = false;          ///< straight, beyond a corner of the face
    bool goesOnBehind = false;          ///< likewise
    std::array<double, 2> sharpness;    ///< at its ends, see edgeSharpness
    std::array<Vector3, 2> otherNormal; ///< of the other side, at its ends
  };

  /// The closest point of a chain.
  struct Place
  {
    std::int32_t segment = None;
    double part = 0.0; ///< of the way along it
    Vector3 point = Vector3::Zero();
    double distance = 0.0; ///< mm, in the plane of the segment, > 0 on the side of the face
    Vector3 gradient = Vector3::Zero(); ///< of the distance, as the place that is asked for moves
  };

  /// How far from a triangle (mm) a chain is not near it any more.
  struct Reach
  {
    double sharp;
    double blunt;
  };

  /// ν: of the body.
  EdgeChains(const PackedMesh& mesh, double poissonRatio, const Reach& reach);

  /// Null where no crease is near.
  const Near* near(std::int32_t triangle) const noexcept
  {
    const std::int32_t place =
      this->NearPlaces.empty() ? None : this->NearPlaces[static_cast<std::size_t>(triangle)];
    return place < 0 ? nullptr : &this->NearLists[static_cast<std::size_t>(place)];
  }
  /// Asks for the memory that near() reads, ahead of its use.
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

  /// The local minimum of the distance along a chain, from one of its segments; `place` local.
  /// In bounded time: as far as some segments on.
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
  std::vector<PackedMesh::CreaseSide> Sides; ///< while it is built
  std::vector<std::int32_t> NearPlaces;
  std::vector<Near> NearLists;
};
} // namespace palpate

#endif
