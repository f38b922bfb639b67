// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * The outer surface of a volume mesh as triangles.
 *
 * Quadrilaterals are split along the diagonal from their first corner. Quadratic triangles are
 * split into four triangles. Each point of the surface is a node of the mesh. Points are numbered
 * in the order of the nodes. Point normals are outward unit vectors, weighted by the angles of the
 * triangles. They are zero at a degenerate point.
 */
#ifndef palpate_BodySurface_h
#define palpate_BodySurface_h

#include "Mechanics/PalpateExport.h"
#include "Solids/FiniteElements/VolumeMesh.h"

namespace palpate
{
/// A position on the surface, given by the nodes of a boundary face and their shape values.
struct SurfacePlace
{
  int count = 0;
  std::array<std::int32_t, 6> nodes{};
  std::array<double, 6> shape{};
};

/// Returns the shape functions of a face with 3, 4 or 6 nodes at the position (ξ, η). The
/// coordinates are those of the triangle (0,0), (1,0), (0,1) or of the square [-1, 1]². Entries
/// beyond the number of nodes are 0.
PALPATE_EXPORT std::array<double, 6> faceShapes(int nodes, const Eigen::Vector2d& xi);

/// The outer surface of a mesh: its points and triangles, and the boundary faces to which the
/// triangles belong.
class PALPATE_EXPORT BodySurface
{
public:
  BodySurface() = default;
  BodySurface(const VolumeMesh& mesh, const MeshTopology& topology);

  std::int32_t pointTotal() const { return static_cast<std::int32_t>(this->Nodes.size()); }
  std::int32_t triangleTotal() const { return static_cast<std::int32_t>(this->Triangles.size()); }

  /// Returns the mesh node of a point.
  std::int32_t node(std::int32_t point) const
  {
    return this->Nodes[static_cast<std::size_t>(point)];
  }
  std::int32_t pointOfNode(std::int32_t node) const
  {
    return this->Points[static_cast<std::size_t>(node)];
  }
  const Eigen::Vector3d& position(std::int32_t point) const
  {
    return this->Positions[static_cast<std::size_t>(point)];
  }
  const Eigen::Vector3d& normal(std::int32_t point) const
  {
    return this->Normals[static_cast<std::size_t>(point)];
  }
  /// Returns the corners of a triangle, as points of the surface.
  const std::array<std::int32_t, 3>& triangle(std::int32_t t) const
  {
    return this->Triangles[static_cast<std::size_t>(t)];
  }
  /// Returns the unit outward normal of a triangle. It is zero if the triangle has no area.
  const Eigen::Vector3d& triangleNormal(std::int32_t t) const
  {
    return this->TriangleNormals[static_cast<std::size_t>(t)];
  }
  double triangleArea(std::int32_t t) const { return this->Areas[static_cast<std::size_t>(t)]; }
  /// Returns the boundary face to which a triangle belongs, as an index in
  /// MeshTopology::boundary().
  std::int32_t faceOfTriangle(std::int32_t t) const
  {
    return this->Faces[static_cast<std::size_t>(t)];
  }
  /// The triangles of a face are firstTriangle(face) to firstTriangle(face + 1) - 1.
  std::int32_t firstTriangle(std::int32_t face) const
  {
    return this->FirstTriangle[static_cast<std::size_t>(face)];
  }

  const std::int32_t* trianglesBegin(std::int32_t point) const
  {
    return this->PointTriangles.data() + this->PointOffset[static_cast<std::size_t>(point)];
  }
  const std::int32_t* trianglesEnd(std::int32_t point) const
  {
    return this->PointTriangles.data() + this->PointOffset[static_cast<std::size_t>(point) + 1];
  }

  /// Returns the position in a triangle with the given barycentric coordinates, with the shape
  /// functions of its face.
  SurfacePlace place(std::int32_t triangle, const Eigen::Vector3d& barycentric) const;

  /// Returns the distance of neighbouring nodes at a point, mm. It is √(2A), where A is the mean
  /// area of the triangles around the point.
  double spacing(std::int32_t point) const;

private:
  struct Face
  {
    int count = 0;
    std::array<std::int32_t, 6> nodes{};
  };

  void connect();

  std::vector<std::int32_t> Nodes;
  std::vector<std::int32_t> Points;
  std::vector<Eigen::Vector3d> Positions;
  std::vector<Eigen::Vector3d> Normals;
  std::vector<Face> FaceNodes;
  std::vector<std::int32_t> FirstTriangle;
  std::vector<std::array<std::int32_t, 3>> Triangles;
  std::vector<std::int32_t> Faces;
  std::vector<Eigen::Vector3d> TriangleNormals;
  std::vector<double> Areas;
  std::vector<std::size_t> PointOffset;
  std::vector<std::int32_t> PointTriangles;
};
} // namespace palpate

#endif
