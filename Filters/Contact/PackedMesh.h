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
/// Receives the progress of building a body, 0 to 1; called by the building thread.
using BuildProgress = std::function<void(double)>;

/**
 * The undeformed surface of a body in the layout for the servo tick: one cache line per triangle
 * with its coordinates, points and neighbours, and a list of the triangles around each point.
 *
 * Triangles are wound counter-clockwise as seen from outside. Triangles and points are renumbered
 * along a space-filling curve, so that neighbours in space are near each other in memory for any
 * order of the input. inputTriangle() and inputPoint() return the indices in the input.
 *
 * Coordinates are stored as float32 relative to the centre of the body's box ("local"); all
 * arithmetic is double. The error of a coordinate is at most half a unit in the last place: 2^-25
 * of its distance from the centre, where the distance is rounded up to a power of two (4e-6 mm at
 * 64 to 128 mm).
 *
 * The side on which a tip is follows from the sign of the vector from the closest point to the tip
 * along the angle-weighted pseudonormal of the closest feature (face, edge or corner). The sign is
 * right for the closest point of any closed 2-manifold (Baerentzen and Aanaes 2005).
 *
 * The triangles are those of a SoundMesh. Triangles without area are not used in contact, but an
 * edge between such a triangle and another one is not a border. An edge with more than two
 * triangles has no neighbour and counts as border.
 *
 * On request sharp edges (creases) are found. The turn of an edge is the angle between the normals
 * of its two triangles. An edge is sharp if its turn is at least the given angle. A turn below
 * BluntTurn must also be at least twice the smallest turn at the other edges of each of the two
 * triangles, because otherwise the facets of a coarsely triangulated sphere would count as faces.
 * An edge is not a crease if no other crease ends at its two points.
 *
 * The surface can be cut along its convex creases, so that a contact followed from triangle to
 * triangle stays on its face. Triangles on different sides of a cut are not neighbours. A point on
 * a cut becomes one point per face, each with the normal of its face. The triangles at a crease
 * between flat faces that is not cut (CreaseCut) are called folded: the normals at their corners
 * differ from those of the faces.
 *
 * Cost: about 105 bytes per triangle. Built in O(n log n), threaded; the result does not depend on
 * the number of threads. Immutable; can be used from any number of threads.
 */
class PALPATE_EXPORT PackedMesh
{
public:
  using Defects = MeshDefects;

  /// Value of neighbour() if there is no triangle across the edge.
  static constexpr std::int32_t Border = -1;
  /// Value of neighbour() if the triangle across the edge has no area.
  static constexpr std::int32_t Seam = -2;
  /// Value of neighbour() if the surface is cut along the edge.
  static constexpr std::int32_t Crease = -3;

  /// A crease with a turn below this angle (rad) is blunt.
  static constexpr double BluntTurn = 1.309; // 75°

  /// One side of a crease.
  struct CreaseSide
  {
    std::int32_t triangle;
    std::int32_t edge;   ///< index of the edge in the triangle
    std::int32_t across; ///< the triangle on the other side
    float turn;          ///< angle between the normals of both triangles, rad
  };

  /// How creases are treated.
  struct CreaseRule
  {
    /// Smallest turn of a sharp edge, rad; with 0, creases are not searched.
    double leastTurn = 0.0;
    bool areCut = true; ///< whether the surface is cut along its convex creases
  };

  /// Copies `pointCount` points (x, y, z of each) and `triangleCount` triangles (three point
  /// indices each).
  PackedMesh(const double* points, std::size_t pointCount, const std::int32_t* triangles,
    std::size_t triangleCount, const BuildProgress& progress, const CreaseRule& creases);
  /// Creates a mesh without a search for creases.
  PackedMesh(const double* points, std::size_t pointCount, const std::int32_t* triangles,
    std::size_t triangleCount);

  /// The number of triangles that are used in contact, and the number of points. A point on a
  /// crease counts once for each face.
  std::size_t triangleCount() const noexcept { return this->Records.size(); }
  std::size_t pointCount() const noexcept { return this->InputPoints.size(); }
  /// Number of points of the input.
  std::size_t inputPointCount() const noexcept { return this->InputPointCount; }
  std::int32_t inputTriangle(std::int32_t triangle) const noexcept
  {
    return this->InputTriangles[static_cast<std::size_t>(triangle)];
  }
  std::int32_t inputPoint(std::int32_t point) const noexcept
  {
    return this->InputPoints[static_cast<std::size_t>(point)];
  }

  /// Origin of the local frame, mm. The axes are those of the body's frame.
  const Vector3& centre() const noexcept { return this->Centre; }
  Vector3 toLocal(const Vector3& position) const noexcept { return position - this->Centre; }

  const TriangleCorners& corners(std::int32_t triangle) const noexcept
  {
    return this->record(triangle).points;
  }
  /// Returns the triangle across edge `edge`, or Border, Seam or Crease.
  std::int32_t neighbour(std::int32_t triangle, int edge) const noexcept
  {
    return this->record(triangle).neighbours[static_cast<std::size_t>(edge)];
  }
  /// Returns the local coordinates of corner k.
  Vector3 corner(std::int32_t triangle, int k) const noexcept
  {
    return Eigen::Map<const Eigen::Vector3f>(
      this->record(triangle).corner[static_cast<std::size_t>(k)].data())
      .cast<double>();
  }
  /// Returns the local coordinates of the three corners, as stored.
  const float* coordinates(std::int32_t triangle) const noexcept
  {
    return this->record(triangle).corner.front().data();
  }
  /// Returns the outward normal with twice the area as its length; faceNormal() returns the unit
  /// normal.
  Vector3 areaNormal(std::int32_t triangle) const noexcept
  {
    const Vector3 a = this->corner(triangle, 0);
    return (this->corner(triangle, 1) - a).cross(this->corner(triangle, 2) - a);
  }
  Vector3 faceNormal(std::int32_t triangle) const noexcept;
  /// Returns the unit angle-weighted normal at a point; zero if no triangle meets the point.
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
  /// Returns whether a tip (local coordinates) whose closest point lies on a crease is inside the
  /// body. The tip is never inside if the closest point is between the ends of the crease, because
  /// the crease is convex. The tip may be inside if the closest point is a corner at which concave
  /// edges also end.
  bool isUnderCorner(const Vector3& tip, const SurfacePoint& closest) const noexcept;
  /// Both sides of each crease, ordered by triangle.
  const std::vector<CreaseSide>& creases() const noexcept { return this->Creases; }
  /// Returns whether a corner of the triangle is on a crease that is not cut.
  bool isFolded(std::int32_t triangle) const noexcept
  {
    return !this->Folded.empty() && this->Folded[static_cast<std::size_t>(triangle)] != 0;
  }

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

  /// Returns the point of the triangle closest to the tip, with the unsigned distance. The tip and
  /// the point have local coordinates.
  TriangleProjection project(const Vector3& tip, std::int32_t triangle) const noexcept
  {
    return projectOnTriangle(
      tip, this->corner(triangle, 0), this->corner(triangle, 1), this->corner(triangle, 2));
  }

  /// As project(), but inline and only for a closest point on the face. For any other closest
  /// point, returns a PlaneFoot other than OnFace.
  PlaneFoot projectOnFace(
    const Vector3& tip, std::int32_t triangle, TriangleProjection& projection) const noexcept
  {
    return palpate::projectOnFace(tip, this->corner(triangle, 0), this->corner(triangle, 1),
      this->corner(triangle, 2), projection);
  }

  /**
   * Returns whether no triangle that shares a corner with this triangle can be nearer to a tip
   * inside the body than this triangle. The closest point of this triangle must be on its face. At
   * a distance s from this triangle, another triangle is at most b s below the plane, where b is a
   * slope. Let the tip have the depth d, and its projection the distance m from the border of the
   * triangle. The distance of the tip from the other triangle is then at least √((m + s)² + (d - b
   * s)²), which is at least d if m >= d b / 2. The test replaces m by the smallest area coordinate
   * times the smallest altitude. This product is at most m, and equals m at the longest edge.
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

  /// Returns whether the tip is certainly farther from the triangle than the given distance. The
  /// test uses the distance from the plane of the triangle.
  bool isPlaneBeyond(
    const Vector3& tip, std::int32_t triangle, double squaredDistance) const noexcept;

  /// Returns a closest point as a SurfacePoint, with the signed distance. All coordinates are
  /// local.
  SurfacePoint orient(
    const Vector3& tip, std::int32_t triangle, const TriangleProjection& projection) const noexcept;

  /// Prefetches the memory of a triangle.
  void prefetch(std::int32_t triangle) const noexcept
  {
    prefetchLine(this->Records.data() + triangle);
  }
  /// Prefetches the index of a triangle in the input.
  void prefetchInput(std::int32_t triangle) const noexcept
  {
    prefetchLine(this->InputTriangles.data() + triangle);
  }

  const Defects& defects() const noexcept { return this->Found; }
  /// Returns the reason why the surface is not a body (SoundMesh), or "".
  const std::string& fault() const noexcept { return this->Fault; }
  /// Returns the memory used, bytes.
  std::size_t memory() const noexcept;

private:
  struct alignas(64) Record
  {
    std::array<std::array<float, 3>, 3> corner;
    TriangleCorners points;
    std::array<std::int32_t, 3> neighbours;
    /// b divided by twice the smallest altitude (see isCertainlyNearest()), 1/mm, rounded up;
    /// infinite if another triangle with a common corner lies under this triangle.
    float steepness;
  };
  static_assert(sizeof(Record) == 64, "one cache line");

  struct Vertex
  {
    std::array<float, 3> normal;
    /// Start of the point's triangles in Ring, shifted by RingShift, plus the flags; or NoRing if
    /// the point has no triangle.
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
  /// Triangles around each point; the last triangle of each point is stored as its bitwise
  /// complement.
  LargeVector<std::int32_t> Ring;
  LargeVector<std::int32_t> InputTriangles;
  LargeVector<std::int32_t> InputPoints;
  /// The angle-weighted normal of all faces around a point that lies on creases.
  struct CornerNormal
  {
    std::int32_t point; ///< in ascending order
    Vector3 normal;
  };
  std::vector<CreaseSide> Creases;
  std::vector<std::uint8_t> Folded; ///< 1 value per triangle; empty if no triangle is folded
  std::vector<CornerNormal> CornerNormals;
  Defects Found;
  std::string Fault;
};
} // namespace palpate

#endif
