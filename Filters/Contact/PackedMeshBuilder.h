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

/// The slope at which the neighbours of a triangle fall below its plane, divided by twice its
/// smallest altitude: the value that PackedMesh::isCertainlyNearest needs, 1/mm, rounded up;
/// infinite if a neighbour is under the triangle.
float steepnessOf(const PackedMesh& mesh, std::int32_t triangle);

/// Builds a PackedMesh in steps: repairs the triangles, sorts them along the curve, numbers the
/// points in that order, finds neighbours, cuts creases, packs the arrays. Not installed.
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
  std::vector<float> Coordinates;         ///< local coordinates of the packed points
  std::vector<std::int32_t> Order;        ///< input triangles: usable ones, then those without area
  std::size_t Usable = 0;                 ///< number of usable triangles
  std::vector<TriangleCorners> Triangles; ///< ordered as Order; corners are packed points
  std::vector<std::int32_t> Twins; ///< the first point with the same coordinates; empty: no twins
  std::vector<TriangleCorners> Joined;  ///< Triangles after twins are joined, if there are any
  std::unique_ptr<TriangleLinks> Links; ///< links of joined()
};
} // namespace palpate

#endif
