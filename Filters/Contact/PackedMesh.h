// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PackedMesh_h
#define palpate_PackedMesh_h

#include "Contact/Contact.h"
#include "Contact/LargePages.h"
#include "Contact/SoundMesh.h"
#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace palpate
{
/// Told how far a body is built, 0 to 1; called by the thread that builds.
using BuildProgress = std::function<void(double)>;

/**
 * The undeformed surface of a body as a tick reads it: one cache line per triangle, with its
 * coordinates, its points and its neighbours; and the triangles around each point.
 *
 * Triangles wind counter-clockwise seen from outside. They and the points are renumbered along a
 * space-filling curve, so that what is near in space is near in memory whatever the order of the
 * input; inputTriangle and inputPoint lead back.
 *
 * Coordinates are float32 about the centre of the body's box ("local"); all arithmetic is double.
 * A coordinate is off by at most half an ulp of its distance from the centre: 2^-25 of it, rounded
 * up to a power of two (4e-6 mm at 64 to 128 mm).
 *
 * The side of a tip is the sign of its offset along the angle-weighted pseudonormal of the closest
 * feature - face, edge or corner - which is right for the closest point of any closed 2-manifold
 * (Baerentzen and Aanaes 2005).
 *
 * The triangles are those of a SoundMesh. Triangles without area take no part in contact, but their
 * neighbours are not left with a border. An edge of more than two triangles has no neighbour across
 * and counts as border.
 *
 * On demand the surface is cut along its sharp convex edges (creases), so that a contact followed
 * from triangle to triangle stays on its face: triangles at a crease are no neighbours, and a point
 * there is one point per face, each with the normal of its face. An edge is sharp where the surface
 * turns by no less than the angle given, and, below BluntTurn, by twice as much as at the other
 * sides of its two triangles where they turn least: the facets of a coarse ball are no faces. An
 * edge between two points at which no other crease ends is not cut.
 *
 * Cost: about 105 bytes per triangle; built in O(n log n), threaded, the same for any number of
 * threads. Immutable, safe from any number of threads.
 */
class PALPATE_EXPORT PackedMesh
{
public:
  using Defects = MeshDefects;

  static constexpr std::int32_t Border = -1; ///< no triangle across an edge
  static constexpr std::int32_t Seam = -2;   ///< one without area across an edge
  static constexpr std::int32_t Crease = -3; ///< cut along a sharp edge

  /// Creases that turn by less are blunt, rad.
  static constexpr double BluntTurn = 1.309; // 75°

  /// One side of a crease.
  struct CreaseSide
  {
    std::int32_t triangle;
    std::int32_t edge;   ///< of the triangle
    std::int32_t across; ///< the triangle on the other side
    float turn;          ///< rad
  };

  /// Copies `pointCount` points (x, y, z) and `triangleCount` triangles (three point indices).
  /// `creaseTurn` (rad): see above; 0: nothing is cut.
  PackedMesh(const double* points, std::size_t pointCount, const std::int32_t* triangles,
    std::size_t triangleCount, const BuildProgress& progress = {}, double creaseTurn = 0.0);

  /// Triangles that take part in contact, and all points; those on creases several times.
  std::size_t triangleCount() const noexcept { return this->Records.size(); }
  std::size_t pointCount() const noexcept { return this->InputPoints.size(); }
  /// Points of the input.
  std::size_t inputPointCount() const noexcept { return this->InputPointCount; }
  std::int32_t inputTriangle(std::int32_t triangle) const noexcept
  {
    return this->InputTriangles[static_cast<std::size_t>(triangle)];
  }
  std::int32_t inputPoint(std::int32_t point) const noexcept
  {
    return this->InputPoints[static_cast<std::size_t>(point)];
  }

  /// Origin of the local frame, mm; the axes are the body's.
  const Vector3& centre() const noexcept { return this->Centre; }
  Vector3 toLocal(const Vector3& position) const noexcept { return position - this->Centre; }

  const TriangleCorners& corners(std::int32_t triangle) const noexcept
  {
    return this->record(triangle).points;
  }
  /// Across edge i, or Border, or Seam, or Crease.
  std::int32_t neighbour(std::int32_t triangle, int edge) const noexcept
  {
    return this->record(triangle).neighbours[static_cast<std::size_t>(edge)];
  }
  /// Local coordinates of corner k.
  Vector3 corner(std::int32_t triangle, int k) const noexcept
  {
    return Eigen::Map<const Eigen::Vector3f>(
      this->record(triangle).corner[static_cast<std::size_t>(k)].data())
      .cast<double>();
  }
  /// Local coordinates of the three corners, as they are kept.
  const float* coordinates(std::int32_t triangle) const noexcept
  {
    return this->record(triangle).corner.front().data();
  }
  /// Outward, twice the area long; and as a unit vector.
  Vector3 areaNormal(std::int32_t triangle) const noexcept
  {
    const Vector3 a = this->corner(triangle, 0);
    return (this->corner(triangle, 1) - a).cross(this->corner(triangle, 2) - a);
  }
  Vector3 faceNormal(std::int32_t triangle) const noexcept;
  /// Unit angle-weighted normal at a point; zero where no triangle meets.
  Vector3 pointNormal(std::int32_t point) const noexcept
  {
    return Eigen::Map<const Eigen::Vector3f>(
      this->Vertices[static_cast<std::size_t>(point)].normal.data())
      .cast<double>();
  }

  bool isOnCrease(std::int32_t point) const noexcept
  {
    const Vertex& vertex = this->Vertices[static_cast<std::size_t>(point)];
    return vertex.ring != NoRing && (vertex.ring & CreaseFlag) != 0;
  }
  /// Both sides of each crease, by triangle.
  const std::vector<CreaseSide>& creases() const noexcept { return this->Creases; }

  /// Calls visit(triangle) for each triangle around a point.
  template <class Visit>
  void visitAround(std::int32_t point, const Visit& visit) const noexcept
  {
    const Vertex& vertex = this->Vertices[static_cast<std::size_t>(point)];
    if (vertex.ring == NoRing)
    {
      return;
    }
    const std::int32_t* next = this->Ring.data() + (vertex.ring >> RingShift);
    for (bool last = false; !last; ++next)
    {
      last = *next < 0;
      visit(last ? ~*next : *next);
    }
  }

  /// Unsigned closest point of one triangle; tip and point local.
  TriangleProjection project(const Vector3& tip, std::int32_t triangle) const noexcept
  {
    return projectOnTriangle(
      tip, this->corner(triangle, 0), this->corner(triangle, 1), this->corner(triangle, 2));
  }

  /// The same if it lies on the face, inline.
  PlaneFoot projectOnFace(
    const Vector3& tip, std::int32_t triangle, TriangleProjection& projection) const noexcept
  {
    return palpate::projectOnFace(tip, this->corner(triangle, 0), this->corner(triangle, 1),
      this->corner(triangle, 2), projection);
  }

  /**
   * Whether the triangle's closest point, on its face, is certain to be no farther from a tip
   * inside the body than any triangle it shares a corner with. Those lie no deeper under its plane
   * than a slope b times their distance from it, so that a point at distance s beyond it is at
   * least √((m + s)² + (d - b s)²) away from a tip at depth d whose foot is m from the triangle's
   * border; that is no less than d if m >= d b / 2. The smallest area coordinate times the smallest
   * altitude is no more than m, and it is the one asked for: exact at the longest edge.
   */
  bool isCertainlyNearest(
    const Vector3& tip, std::int32_t triangle, const TriangleProjection& projection) const noexcept
  {
    const double least = projection.weights.minCoeff();
    const double need{ this->record(triangle).steepness };
    const Vector3 inward = this->corner(triangle, 0) - tip;
    return least * least >= need * need * projection.squaredDistance &&
      this->areaNormal(triangle).dot(inward) > 0.0;
  }

  /// Whether the tip is surely farther than the given distance: farther from the triangle's plane.
  bool isPlaneBeyond(
    const Vector3& tip, std::int32_t triangle, double squaredDistance) const noexcept;

  /// Adds the side of the tip to a closest point; all local.
  SurfacePoint orient(
    const Vector3& tip, std::int32_t triangle, const TriangleProjection& projection) const noexcept;

  /// Asks for the memory of a triangle ahead of its use.
  void prefetch(std::int32_t triangle) const noexcept
  {
    prefetchLine(this->Records.data() + triangle);
  }
  /// The same of its number in the input.
  void prefetchInput(std::int32_t triangle) const noexcept
  {
    prefetchLine(this->InputTriangles.data() + triangle);
  }

  const Defects& defects() const noexcept { return this->Found; }
  /// Why the surface is no body (SoundMesh), or "".
  const std::string& fault() const noexcept { return this->Fault; }
  /// Bytes held.
  std::size_t memory() const noexcept;

private:
  struct alignas(64) Record
  {
    std::array<std::array<float, 3>, 3> corner;
    TriangleCorners points;
    std::array<std::int32_t, 3> neighbours;
    /// b over twice the smallest altitude, see isCertainlyNearest; 1/mm, rounded up; infinite where
    /// a neighbour lies under the triangle.
    float steepness;
  };
  static_assert(sizeof(Record) == 64, "one cache line");

  struct Vertex
  {
    std::array<float, 3> normal;
    /// Where its triangles begin in Ring, shifted, and flags; or NoRing.
    std::uint32_t ring;
  };
  static constexpr std::uint32_t BorderFlag = 1;
  static constexpr std::uint32_t CreaseFlag = 2;
  static constexpr unsigned RingShift = 2;
  static constexpr std::uint32_t NoRing = ~std::uint32_t{ 0 };

  class Builder;

  const Record& record(std::int32_t triangle) const noexcept
  {
    return this->Records[static_cast<std::size_t>(triangle)];
  }

  Vector3 Centre = Vector3::Zero();
  std::size_t InputPointCount = 0;
  LargeVector<Record> Records;
  LargeVector<Vertex> Vertices;
  LargeVector<std::int32_t> Ring; ///< triangles around points, the last of each as its complement
  LargeVector<std::int32_t> InputTriangles;
  LargeVector<std::int32_t> InputPoints;
  std::vector<CreaseSide> Creases;
  Defects Found;
  std::string Fault;
};
} // namespace palpate

#endif
