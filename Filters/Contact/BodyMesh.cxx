// SPDX-License-Identifier: BSD-3-Clause
#include "BodyMesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace palpate
{
namespace
{
/// A triangle is degenerate when its height is lost in the rounding of its coordinates.
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
} // namespace

BodyMesh::BodyMesh(const double* points, std::size_t pointCount, const std::int32_t* triangles,
  std::size_t triangleCount)
  : Points(points, points + 3 * pointCount)
  , Triangles(triangleCount)
  , Neighbours(triangleCount, { Border, Border, Border })
{
  for (std::size_t t = 0; t < triangleCount; ++t)
  {
    this->Triangles[t] = { triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2] };
  }
  this->findUsable();
  this->linkPoints();
  this->linkNeighbours();
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
      this->Neighbours[t] = { Unusable, Unusable, Unusable };
    }
  }
}

void BodyMesh::linkPoints()
{
  this->IncidentStart.assign(this->pointCount() + 1, 0);
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    if (this->isUsable(static_cast<std::int32_t>(t)))
    {
      for (const std::int32_t corner : this->Triangles[t])
      {
        ++this->IncidentStart[static_cast<std::size_t>(corner) + 1];
      }
    }
  }
  for (std::size_t i = 1; i < this->IncidentStart.size(); ++i)
  {
    this->IncidentStart[i] += this->IncidentStart[i - 1];
  }
  this->Incident.resize(this->IncidentStart.back());
  std::vector<std::size_t> next(this->IncidentStart.begin(), this->IncidentStart.end() - 1);
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    if (this->isUsable(static_cast<std::int32_t>(t)))
    {
      for (const std::int32_t corner : this->Triangles[t])
      {
        this->Incident[next[static_cast<std::size_t>(corner)]++] = static_cast<std::int32_t>(t);
      }
    }
  }
}

void BodyMesh::linkNeighbours()
{
  this->OnBorder.assign(this->pointCount(), false);
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    if (!this->isUsable(static_cast<std::int32_t>(t)))
    {
      continue;
    }
    for (std::size_t e = 0; e < 3; ++e)
    {
      const std::int32_t from = this->Triangles[t][e];
      const std::int32_t to = this->Triangles[t][(e + 1) % 3];
      int alike = 0;
      int across = 0;
      bool first = true; // of the triangles at this edge, so that it is counted once
      std::int32_t neighbour = Border;
      const auto around = this->trianglesAround(from);
      for (const std::int32_t* other = around[0]; other != around[1]; ++other)
      {
        const auto& corner = this->corners(*other);
        for (std::size_t k = 0; k < 3; ++k)
        {
          const bool isAlike = corner[k] == from && corner[(k + 1) % 3] == to;
          const bool isAcross = corner[k] == to && corner[(k + 1) % 3] == from;
          alike += isAlike;
          if (isAcross)
          {
            ++across;
            neighbour = *other;
          }
          first = first && !((isAlike || isAcross) && *other < static_cast<std::int32_t>(t));
        }
      }
      if (alike == 1 && across == 1)
      {
        this->Neighbours[t][e] = neighbour;
        continue;
      }
      if (first)
      {
        ++(alike + across == 1 ? this->Found.borderEdges : this->Found.nonManifoldEdges);
      }
      this->OnBorder[static_cast<std::size_t>(from)] = true;
      this->OnBorder[static_cast<std::size_t>(to)] = true;
    }
  }
}

void BodyMesh::computePointNormals()
{
  this->PointNormals.assign(this->Points.size(), 0.0);
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    const auto triangle = static_cast<std::int32_t>(t);
    if (!this->isUsable(triangle))
    {
      continue;
    }
    const Vector3 normal = this->faceNormal(triangle);
    const auto& corner = this->Triangles[t];
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Vector3 at = this->point(corner[k]);
      const double angle =
        angleBetween(this->point(corner[(k + 1) % 3]) - at, this->point(corner[(k + 2) % 3]) - at);
      Eigen::Map<Vector3>(this->PointNormals.data() + 3 * static_cast<std::size_t>(corner[k])) +=
        angle * normal;
    }
  }
  for (std::size_t i = 0; i < this->pointCount(); ++i)
  {
    Eigen::Map<Vector3> normal(this->PointNormals.data() + 3 * i);
    const double length = normal.norm();
    if (length > 0.0)
    {
      normal /= length;
    }
  }
}

Vector3 BodyMesh::faceNormal(std::int32_t triangle) const noexcept
{
  const auto& corner = this->corners(triangle);
  const Vector3 a = this->point(corner[0]);
  const Vector3 normal = (this->point(corner[1]) - a).cross(this->point(corner[2]) - a);
  return normal / normal.norm();
}

bool BodyMesh::isClosed() const noexcept
{
  return this->Found.borderEdges == 0 && this->Found.nonManifoldEdges == 0 &&
    this->Found.notFinite == 0 && this->Found.badIndex == 0 && !this->Incident.empty();
}

double BodyMesh::enclosedVolume() const noexcept
{
  if (this->Incident.empty())
  {
    return 0.0;
  }
  const Vector3 origin = this->point(this->corners(this->Incident.front())[0]);
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

SurfacePoint BodyMesh::orient(
  const Vector3& tip, std::int32_t triangle, const TriangleProjection& projection) const noexcept
{
  SurfacePoint found;
  found.triangle = triangle;
  found.projection = projection;
  const auto feature = static_cast<std::size_t>(projection.feature);
  Vector3 normal;
  if (projection.feature == TriangleFeature::Face)
  {
    normal = this->faceNormal(triangle);
  }
  else if (feature < 3)
  {
    const std::int32_t corner = this->corners(triangle)[feature];
    normal = this->pointNormal(corner);
    found.onBorder = this->OnBorder[static_cast<std::size_t>(corner)];
  }
  else
  {
    normal = this->faceNormal(triangle);
    const std::int32_t across = this->Neighbours[static_cast<std::size_t>(triangle)][feature - 3];
    found.onBorder = across < 0;
    if (across >= 0)
    {
      normal += this->faceNormal(across);
    }
  }
  const double distance = std::sqrt(projection.squaredDistance);
  found.signedDistance = (tip - projection.point).dot(normal) < 0.0 ? -distance : distance;
  return found;
}
} // namespace palpate
