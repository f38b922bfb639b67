// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PackedMeshBuilder_h
#define palpate_PackedMeshBuilder_h

#include "Contact/PackedMesh.h"
#include "Contact/SoundMesh.h"
#include "Contact/TriangleLinks.h"

#include <cstdint>
#include <memory>

namespace palpate
{
class CreaseCut;

/// Returns the value that PackedMesh::isCertainlyNearest needs: the slope at which other triangles
/// fall below the plane of a triangle, divided by twice the smallest altitude of the triangle,
/// 1/mm, rounded up. Infinite if another triangle with a common corner lies under the triangle.
float steepnessOf(const PackedMesh& mesh, std::int32_t triangle);

/// Builds a PackedMesh in steps: repairs the triangles, sorts them along the curve, numbers the
/// points in the order of the triangles, finds neighbours, cuts creases, and packs the arrays. This
/// header is not installed.
class PackedMesh::Builder
{
public:
  Builder(PackedMesh& mesh, const BuildProgress& progress, const CreaseRule& creases)
    : Mesh(mesh)
    , Progress(progress)
    , Creases(creases)
  {
  }
  void build(const double* points, std::size_t pointCount, const std::int32_t* triangles,
    std::size_t triangleCount);

private:
  void report(double done) const;
  void orderTriangles(const SoundMesh& sound);
  void numberPoints(const SoundMesh& sound);
  void findNeighbours(const SoundMesh& sound);
  void joinPoints(const SoundMesh& sound);
  void findCreases();
  void cut(const CreaseCut& creases);
  void packRings();
  void packRecords();
  void markCreases();
  Vector3 sumOfNormals(std::size_t point) const;
  void computePointNormals();
  void computeCornerNormals();
  void computeBends();

  const std::vector<TriangleCorners>& joined() const
  {
    return this->Joined.empty() ? this->Triangles : this->Joined;
  }
  std::size_t twinOf(std::size_t point) const
  {
    return this->Twins.empty() ? point : static_cast<std::size_t>(this->Twins[point]);
  }

  PackedMesh& Mesh;
  const BuildProgress& Progress;
  const CreaseRule Creases;
  std::size_t PointCount = 0;
  std::vector<float> Coordinates; ///< local coordinates of the packed points
  /// Indices of input triangles: first the usable ones, then those without area.
  std::vector<std::int32_t> Order;
  std::size_t Usable = 0; ///< number of usable triangles
  /// In the order of Order; the corners are indices of packed points.
  std::vector<TriangleCorners> Triangles;
  /// For each point, the first point with the same coordinates; empty if all points differ.
  std::vector<std::int32_t> Twins;
  /// The triangles after points with the same coordinates were joined; empty if all points differ.
  std::vector<TriangleCorners> Joined;
  std::unique_ptr<TriangleLinks> Links; ///< links of the triangles of joined()
};
} // namespace palpate

#endif
