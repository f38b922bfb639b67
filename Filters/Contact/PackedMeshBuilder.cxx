// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/PackedMeshBuilder.h"

#include "Contact/HilbertCurve.h"
#include "Contact/ParallelRanges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
Vector3 pointAt(const std::vector<float>& points, std::int32_t index)
{
  return Eigen::Map<const Eigen::Vector3f>(points.data() + 3 * static_cast<std::size_t>(index))
    .cast<double>();
}

double cornerAngle(const Vector3& u, const Vector3& v)
{
  return std::atan2(u.cross(v).norm(), u.dot(v));
}
} // namespace

void PackedMesh::Builder::report(double done) const
{
  if (this->Progress)
  {
    this->Progress(done);
  }
}

void PackedMesh::Builder::build(const double* points, std::size_t pointCount,
  const std::int32_t* triangles, std::size_t triangleCount)
{
  const SoundMesh sound(points, pointCount, triangles, triangleCount);
  this->PointCount = pointCount;
  this->Mesh.InputPointCount = pointCount;
  this->Mesh.Centre = sound.centre();
  this->Mesh.Found = sound.defects();
  this->Mesh.Fault = sound.fault();
  this->report(0.2);
  this->orderTriangles(sound);
  this->report(0.3);
  this->numberPoints(sound);
  this->report(0.4);
  this->findNeighbours(sound);
  if (this->Creases.leastTurn > 0.0)
  {
    this->findCreases();
  }
  this->report(0.6);
  this->packRings();
  this->packRecords();
  if (!this->Mesh.Creases.empty())
  {
    this->markCreases();
  }
  this->computePointNormals();
  this->computeCornerNormals();
  this->report(0.75);
  this->computeBends();
  this->report(0.95);
}

void PackedMesh::Builder::orderTriangles(const SoundMesh& sound)
{
  for (const bool withoutArea : { false, true })
  {
    for (std::size_t t = 0; t < sound.triangles().size(); ++t)
    {
      if (sound.triangles()[t][0] >= 0 && sound.isWithoutArea(t) == withoutArea)
      {
        this->Order.push_back(static_cast<std::int32_t>(t));
      }
    }
    this->Usable = withoutArea ? this->Usable : this->Order.size();
  }
  std::vector<std::int32_t> usable(
    this->Order.begin(), this->Order.begin() + static_cast<std::ptrdiff_t>(this->Usable));
  if (!usable.empty())
  {
    sortAlongCurve(usable, sound.triangles().front().data(), sound.coordinates().data());
  }
  std::copy(usable.begin(), usable.end(), this->Order.begin());
}

void PackedMesh::Builder::numberPoints(const SoundMesh& sound)
{
  constexpr std::int32_t unseen = -1;
  std::vector<std::int32_t> packed(this->PointCount, unseen);
  LargeVector<std::int32_t>& inputs = this->Mesh.InputPoints;
  inputs.reserve(this->PointCount);
  const auto numberOf = [&](std::int32_t input)
  {
    std::int32_t& number = packed[static_cast<std::size_t>(input)];
    if (number == unseen)
    {
      number = static_cast<std::int32_t>(inputs.size());
      inputs.push_back(input);
    }
    return number;
  };
  this->Triangles.reserve(this->Order.size());
  for (const std::int32_t t : this->Order)
  {
    const TriangleCorners& corner = sound.triangles()[static_cast<std::size_t>(t)];
    const std::int32_t a = numberOf(corner[0]);
    const std::int32_t b = numberOf(corner[1]);
    this->Triangles.push_back({ a, b, numberOf(corner[2]) });
  }
  for (std::size_t i = 0; i < this->PointCount; ++i)
  {
    numberOf(static_cast<std::int32_t>(i)); // the last numbers are for points without triangles
  }
  this->Coordinates.resize(sound.coordinates().size());
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    std::copy_n(sound.coordinates().data() + 3 * static_cast<std::size_t>(inputs[i]), 3,
      this->Coordinates.data() + 3 * i);
  }
  this->Mesh.InputTriangles.assign(
    this->Order.begin(), this->Order.begin() + static_cast<std::ptrdiff_t>(this->Usable));
}

void PackedMesh::Builder::findNeighbours(const SoundMesh& sound)
{
  if (sound.hasJoinedPoints())
  {
    this->joinPoints(sound);
  }
  this->Links = std::make_unique<TriangleLinks>(this->joined(), this->PointCount);
}

void PackedMesh::Builder::joinPoints(const SoundMesh& sound)
{
  constexpr std::int32_t unseen = -1;
  // For each point, the index of the first point at the same position.
  std::vector<std::int32_t> packed(this->PointCount, unseen);
  this->Twins.resize(this->PointCount);
  for (std::size_t i = 0; i < this->PointCount; ++i)
  {
    std::int32_t& first =
      packed[static_cast<std::size_t>(sound.firstAt(this->Mesh.InputPoints[i]))];
    first = first == unseen ? static_cast<std::int32_t>(i) : first;
    this->Twins[i] = first;
  }
  this->Joined = this->Triangles;
  for (TriangleCorners& corners : this->Joined)
  {
    for (std::int32_t& corner : corners)
    {
      corner = this->Twins[static_cast<std::size_t>(corner)];
    }
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
    {
      // The triangle has only two different corners; its neighbours share this edge.
      corners[0] = -1;
    }
  }
}

void PackedMesh::Builder::packRings()
{
  this->Mesh.Vertices.resize(this->PointCount);
  this->Mesh.Ring.reserve(3 * this->Usable);
  const auto pack = [this](std::size_t point)
  {
    Vertex& vertex = this->Mesh.Vertices[point];
    vertex.ring = NoRing;
    const auto start = static_cast<std::uint32_t>(this->Mesh.Ring.size());
    const auto around = this->Links->around(static_cast<std::int32_t>(point));
    std::copy_if(around[0], around[1], std::back_inserter(this->Mesh.Ring),
      [this](std::int32_t t) { return static_cast<std::size_t>(t) < this->Usable; });
    if (this->Mesh.Ring.size() > start)
    {
      this->Mesh.Ring.back() = ~this->Mesh.Ring.back();
      const bool onBorder = this->Links->onBorder(static_cast<std::int32_t>(point));
      vertex.ring = (start << RingShift) | (onBorder ? BorderFlag : 0U);
    }
  };
  for (std::size_t point = 0; point < this->PointCount; ++point)
  {
    if (this->twinOf(point) == point) // the point is the first of the points with its coordinates
    {
      pack(point);
    }
    else
    {
      this->Mesh.Vertices[point].ring = this->Mesh.Vertices[this->twinOf(point)].ring;
    }
  }
}

void PackedMesh::Builder::packRecords()
{
  this->Mesh.Records.resize(this->Usable);
  std::atomic<std::size_t> borderEdges{ 0 };
  forRanges(this->Usable,
    [this, &borderEdges](std::size_t first, std::size_t last)
    {
      for (std::size_t t = first; t < last; ++t)
      {
        Record& record = this->Mesh.Records[t];
        record.points = this->Triangles[t];
        record.neighbours = this->Links->neighbours(t);
        for (std::size_t k = 0; k < 3; ++k)
        {
          std::copy_n(this->Coordinates.data() + 3 * static_cast<std::size_t>(record.points[k]), 3,
            record.corner[k].data());
          std::int32_t& neighbour = record.neighbours[k];
          borderEdges += neighbour == TriangleLinks::Border;
          if (neighbour >= static_cast<std::int32_t>(this->Usable))
          {
            neighbour = Seam;
          }
          else if (neighbour < 0)
          {
            neighbour = Border;
          }
        }
      }
    });
  this->Mesh.Found.borderEdges = borderEdges;
}

/// Returns the angle-weighted sum of the normals of the triangles around a point.
Vector3 PackedMesh::Builder::sumOfNormals(std::size_t point) const
{
  const Vector3 at = pointAt(this->Coordinates, static_cast<std::int32_t>(point));
  const auto self = static_cast<std::int32_t>(this->twinOf(point));
  Vector3 sum = Vector3::Zero();
  this->Mesh.visitAround(static_cast<std::int32_t>(point),
    [&](std::int32_t triangle)
    {
      const TriangleCorners& corners = this->joined()[static_cast<std::size_t>(triangle)];
      const int k = corners[0] == self ? 0 : corners[1] == self ? 1 : 2;
      const Vector3 u = this->Mesh.corner(triangle, (k + 1) % 3) - at;
      const Vector3 v = this->Mesh.corner(triangle, (k + 2) % 3) - at;
      const Vector3 normal = u.cross(v);
      sum += cornerAngle(u, v) / normal.norm() * normal;
    });
  return sum;
}

void PackedMesh::Builder::computePointNormals()
{
  forRanges(this->PointCount,
    [this](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const Vector3 sum = this->sumOfNormals(i);
        const double length = sum.norm();
        Eigen::Map<Eigen::Vector3f>(this->Mesh.Vertices[i].normal.data()) =
          (length > 0.0 ? Vector3(sum / length) : Vector3::Zero().eval()).cast<float>();
      }
    });
}

void PackedMesh::Builder::computeBends()
{
  forRanges(this->Usable,
    [this](std::size_t first, std::size_t last)
    {
      for (std::size_t t = first; t < last; ++t)
      {
        this->Mesh.Records[t].steepness = steepnessOf(this->Mesh, static_cast<std::int32_t>(t));
      }
    });
}
} // namespace palpate
