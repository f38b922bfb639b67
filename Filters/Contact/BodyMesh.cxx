// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/BodyMesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace palpate
{
namespace
{
/// Returns whether the height of a triangle exceeds the rounding error of its coordinates.
bool hasArea(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const double longest =
    std::max({ (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm() });
  const double magnitude = std::max({ a.squaredNorm(), b.squaredNorm(), c.squaredNorm(), longest });
  const double doubleArea = (b - a).cross(c - a).norm();
  return doubleArea > 4e-16 * std::sqrt(longest * magnitude);
}

double angleBetween(const Vector3& u, const Vector3& v)
{
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

Vector3 placeOf(const double* points, std::int32_t index)
{
  return Eigen::Map<const Vector3>(points + 3 * static_cast<std::size_t>(index));
}

/// Adds the normal of a triangle to the normals of its three corners, each weighted by the angle of
/// the triangle at the corner.
void addNormal(const double* points, const TriangleCorners& corner, std::vector<double>& normals)
{
  const std::array<Vector3, 3> place{ placeOf(points, corner[0]), placeOf(points, corner[1]),
    placeOf(points, corner[2]) };
  const Vector3 normal = (place[1] - place[0]).cross(place[2] - place[0]).normalized();
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double angle = angleBetween(place[(k + 1) % 3] - place[k], place[(k + 2) % 3] - place[k]);
    Eigen::Map<Vector3>(normals.data() + 3 * static_cast<std::size_t>(corner[k])) += angle * normal;
  }
}

/// Scales all vectors to unit length, except zero vectors.
void normalize(std::vector<double>& normals)
{
  for (std::size_t i = 0; i < normals.size(); i += 3)
  {
    Eigen::Map<Vector3> normal(normals.data() + i);
    const double length = normal.norm();
    if (length > 0.0)
    {
      normal /= length;
    }
  }
}
} // namespace

BodyMesh::BodyMesh(const double* points, std::size_t pointCount, const std::int32_t* triangles,
  std::size_t triangleCount)
  : Points(points, points + 3 * pointCount)
  , Triangles(triangleCount)
  , Usable(triangleCount, true)
{
  for (std::size_t t = 0; t < triangleCount; ++t)
  {
    this->Triangles[t] = { triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2] };
  }
  this->findUsable();
  std::vector<TriangleCorners> usable = this->Triangles;
  for (std::size_t t = 0; t < usable.size(); ++t)
  {
    usable[t][0] = this->Usable[t] ? usable[t][0] : -1;
  }
  this->Links = std::make_shared<const TriangleLinks>(usable, pointCount);
  this->Found.borderEdges = this->Links->borderEdges();
  this->Found.nonManifoldEdges = this->Links->nonManifoldEdges();
  this->computePointNormals();
}

void BodyMesh::findUsable()
{
  const auto count = static_cast<std::int32_t>(this->pointCount());
  const auto inRange = [count](std::int32_t i) { return i >= 0 && i < count; };
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    const auto& corner = this->Triangles[t];
    std::size_t* defect = nullptr;
    if (!inRange(corner[0]) || !inRange(corner[1]) || !inRange(corner[2]))
    {
      defect = &this->Found.badIndex;
    }
    else
    {
      const Vector3 a = this->point(corner[0]);
      const Vector3 b = this->point(corner[1]);
      const Vector3 c = this->point(corner[2]);
      if (!a.allFinite() || !b.allFinite() || !c.allFinite())
      {
        defect = &this->Found.notFinite;
      }
      else if (!hasArea(a, b, c))
      {
        defect = &this->Found.degenerate;
      }
    }
    if (defect)
    {
      ++*defect;
      this->Usable[t] = false;
    }
  }
}

void BodyMesh::computePointNormals()
{
  this->PointNormals.assign(this->Points.size(), 0.0);
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    if (this->Usable[t])
    {
      addNormal(this->Points.data(), this->Triangles[t], this->PointNormals);
    }
  }
  normalize(this->PointNormals);
}

std::vector<double> angleWeightedNormals(const double* points, std::size_t pointCount,
  const std::int32_t* triangles, std::size_t triangleCount)
{
  std::vector<double> normals(3 * pointCount, 0.0);
  for (std::size_t t = 0; t < triangleCount; ++t)
  {
    const TriangleCorners corner{ triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2] };
    const Vector3 a = placeOf(points, corner[0]);
    const Vector3 b = placeOf(points, corner[1]);
    const Vector3 c = placeOf(points, corner[2]);
    if (a.allFinite() && b.allFinite() && c.allFinite() && hasArea(a, b, c))
    {
      addNormal(points, corner, normals);
    }
  }
  normalize(normals);
  return normals;
}

bool BodyMesh::isClosed() const noexcept
{
  return this->Found.borderEdges == 0 && this->Found.nonManifoldEdges == 0 &&
    this->Found.notFinite == 0 && this->Found.badIndex == 0 && this->hasTriangles();
}

double BodyMesh::enclosedVolume() const noexcept
{
  if (!this->hasTriangles())
  {
    return 0.0;
  }
  const auto first = std::find(this->Usable.begin(), this->Usable.end(), true);
  const Vector3 origin =
    this->point(this->Triangles[static_cast<std::size_t>(first - this->Usable.begin())][0]);
  double sixfold = 0.0;
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    if (this->isUsable(static_cast<std::int32_t>(t)))
    {
      const auto& corner = this->Triangles[t];
      sixfold += (this->point(corner[0]) - origin)
                   .dot((this->point(corner[1]) - origin).cross(this->point(corner[2]) - origin));
    }
  }
  return sixfold / 6.0;
}

TriangleProjection BodyMesh::project(const Vector3& tip, std::int32_t triangle) const noexcept
{
  const auto& corner = this->corners(triangle);
  return projectOnTriangle(
    tip, this->point(corner[0]), this->point(corner[1]), this->point(corner[2]));
}

} // namespace palpate
