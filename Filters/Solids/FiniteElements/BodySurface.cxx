// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/FiniteElements/BodySurface.h"

#include <Eigen/Geometry>

#include <cmath>

namespace palpate
{
namespace
{
using Corners = std::array<int, 3>;

/// Returns the triangles into which a face is split, in the face's node numbers.
const std::vector<Corners>& splitOf(int nodes)
{
  static const std::vector<Corners> triangle = { { 0, 1, 2 } };
  static const std::vector<Corners> quadrilateral = { { 0, 1, 2 }, { 0, 2, 3 } };
  static const std::vector<Corners> quadratic = { { 0, 3, 5 }, { 3, 1, 4 }, { 5, 4, 2 },
    { 3, 4, 5 } };
  return nodes == 3 ? triangle : nodes == 4 ? quadrilateral : quadratic;
}

/// Returns the coordinates of a face's node i, as in faceShapes().
Eigen::Vector2d faceCoordinates(int nodes, int i)
{
  constexpr std::array<std::array<double, 2>, 4> square = { { { -1, -1 }, { 1, -1 }, { 1, 1 },
    { -1, 1 } } };
  constexpr std::array<std::array<double, 2>, 6> triangle = { { { 0, 0 }, { 1, 0 }, { 0, 1 },
    { 0.5, 0 }, { 0.5, 0.5 }, { 0, 0.5 } } };
  const auto& c =
    nodes == 4 ? square[static_cast<std::size_t>(i)] : triangle[static_cast<std::size_t>(i)];
  return { c[0], c[1] };
}
} // namespace

std::array<double, 6> faceShapes(int nodes, const Eigen::Vector2d& xi)
{
  if (nodes == 4)
  {
    return { 0.25 * (1 - xi[0]) * (1 - xi[1]), 0.25 * (1 + xi[0]) * (1 - xi[1]),
      0.25 * (1 + xi[0]) * (1 + xi[1]), 0.25 * (1 - xi[0]) * (1 + xi[1]), 0.0, 0.0 };
  }
  const double a = 1.0 - xi[0] - xi[1];
  const double b = xi[0];
  const double c = xi[1];
  if (nodes == 3)
  {
    return { a, b, c, 0.0, 0.0, 0.0 };
  }
  return { a * (2 * a - 1), b * (2 * b - 1), c * (2 * c - 1), 4 * a * b, 4 * b * c, 4 * c * a };
}

BodySurface::BodySurface(const VolumeMesh& mesh, const MeshTopology& topology)
  : Points(static_cast<std::size_t>(mesh.nodeTotal()), -1)
{
  for (const BoundaryFace& boundary : topology.boundary())
  {
    const VolumeElement& element = mesh.elements[static_cast<std::size_t>(boundary.element)];
    const ElementFace& own = elementFace(element.kind, boundary.face);
    Face face;
    face.count = own.nodes;
    for (std::size_t i = 0; i < static_cast<std::size_t>(own.nodes); ++i)
    {
      face.nodes[i] = element.nodes[static_cast<std::size_t>(own.node[i])];
      this->Points[static_cast<std::size_t>(face.nodes[i])] = 0;
    }
    this->FaceNodes.push_back(face);
  }
  for (std::int32_t i = 0; i < mesh.nodeTotal(); ++i)
  {
    if (this->Points[static_cast<std::size_t>(i)] == 0)
    {
      this->Points[static_cast<std::size_t>(i)] = this->pointTotal();
      this->Nodes.push_back(i);
      this->Positions.emplace_back(mesh.nodes.col(i));
    }
  }
  for (std::size_t f = 0; f < this->FaceNodes.size(); ++f)
  {
    this->FirstTriangle.push_back(this->triangleTotal());
    const Face& face = this->FaceNodes[f];
    for (const Corners& corners : splitOf(face.count))
    {
      std::array<std::int32_t, 3> triangle{};
      for (std::size_t i = 0; i < 3; ++i)
      {
        triangle[i] = this->pointOfNode(face.nodes[static_cast<std::size_t>(corners[i])]);
      }
      this->Triangles.push_back(triangle);
      this->Faces.push_back(static_cast<std::int32_t>(f));
    }
  }
  this->FirstTriangle.push_back(this->triangleTotal());
  this->connect();
}

void BodySurface::connect()
{
  this->Normals.assign(this->Nodes.size(), Eigen::Vector3d::Zero());
  this->PointOffset.assign(this->Nodes.size() + 1, 0);
  for (const auto& triangle : this->Triangles)
  {
    std::array<Eigen::Vector3d, 3> edge;
    for (std::size_t i = 0; i < 3; ++i)
    {
      edge[i] = this->position(triangle[(i + 1) % 3]) - this->position(triangle[i]);
    }
    const Eigen::Vector3d area = edge[0].cross(edge[1]);
    const double length = area.norm();
    this->Areas.push_back(0.5 * length);
    const Eigen::Vector3d normal = length > 0.0 ? Eigen::Vector3d(area / length) : area;
    this->TriangleNormals.push_back(normal);
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Eigen::Vector3d back = -edge[(i + 2) % 3];
      const double angle = std::atan2(edge[i].cross(back).norm(), edge[i].dot(back));
      this->Normals[static_cast<std::size_t>(triangle[i])] += angle * normal;
      ++this->PointOffset[static_cast<std::size_t>(triangle[i]) + 1];
    }
  }
  for (Eigen::Vector3d& normal : this->Normals)
  {
    const double length = normal.norm();
    normal = length > 1e-6 ? Eigen::Vector3d(normal / length) : Eigen::Vector3d::Zero();
  }
  for (std::size_t i = 1; i < this->PointOffset.size(); ++i)
  {
    this->PointOffset[i] += this->PointOffset[i - 1];
  }
  this->PointTriangles.resize(this->PointOffset.back());
  std::vector<std::size_t> next(this->PointOffset.begin(), this->PointOffset.end() - 1);
  for (std::int32_t t = 0; t < this->triangleTotal(); ++t)
  {
    for (const std::int32_t point : this->triangle(t))
    {
      this->PointTriangles[next[static_cast<std::size_t>(point)]++] = t;
    }
  }
}

SurfacePlace BodySurface::place(std::int32_t triangle, const Eigen::Vector3d& barycentric) const
{
  const std::int32_t f = this->faceOfTriangle(triangle);
  const Face& face = this->FaceNodes[static_cast<std::size_t>(f)];
  const Corners& corners =
    splitOf(face.count)[static_cast<std::size_t>(triangle - this->firstTriangle(f))];
  Eigen::Vector2d xi = Eigen::Vector2d::Zero();
  for (int i = 0; i < 3; ++i)
  {
    xi += barycentric[i] * faceCoordinates(face.count, corners[static_cast<std::size_t>(i)]);
  }
  return { face.count, face.nodes, faceShapes(face.count, xi) };
}

double BodySurface::spacing(std::int32_t point) const
{
  double area = 0.0;
  for (const std::int32_t* t = this->trianglesBegin(point); t != this->trianglesEnd(point); ++t)
  {
    area += this->triangleArea(*t);
  }
  const auto count = static_cast<double>(this->trianglesEnd(point) - this->trianglesBegin(point));
  return count > 0.0 ? std::sqrt(2.0 * area / count) : 0.0;
}
} // namespace palpate
