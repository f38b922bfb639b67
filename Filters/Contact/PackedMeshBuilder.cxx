// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/PackedMeshBuilder.h"

#include "Contact/HilbertCurve.h"
#include "Contact/MeshRepair.h"
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
Vector3 pointAt(const double* points, std::int32_t index)
{
  return Eigen::Map<const Vector3>(points + 3 * static_cast<std::size_t>(index));
}

Vector3 pointAt(const std::vector<float>& points, std::int32_t index)
{
  return Eigen::Map<const Eigen::Vector3f>(points.data() + 3 * static_cast<std::size_t>(index))
    .cast<double>();
}

/// Whether the rounded triangle still has an area, on the same side as the given one.
bool keepsItsArea(const std::array<Vector3, 3>& given, const std::array<Vector3, 3>& rounded)
{
  const auto normalOf = [](const std::array<Vector3, 3>& t) -> Vector3
  { return (t[1] - t[0]).cross(t[2] - t[0]); };
  const Vector3 normal = normalOf(rounded);
  const double longest = std::max({ (rounded[1] - rounded[0]).squaredNorm(),
    (rounded[2] - rounded[1]).squaredNorm(), (rounded[0] - rounded[2]).squaredNorm() });
  // Differences of floats are exact in double: only the products round.
  return normal.norm() > 4e-16 * longest && normal.dot(normalOf(given)) > 0.0;
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
  this->PointCount = pointCount;
  this->Mesh.InputPointCount = pointCount;
  std::vector<Part> parts(triangleCount, Part::Usable);
  this->placeCentre(points, triangles, parts);
  this->roundPoints(points);
  this->findParts(points, triangles, parts);
  this->report(0.1);
  this->orderTriangles(triangles, parts);
  this->report(0.3);
  this->numberPoints(triangles);
  this->report(0.4);
  this->findNeighbours();
  if (this->CreaseTurn > 0.0)
  {
    this->cutCreases();
  }
  this->report(0.6);
  this->packRings();
  this->packRecords();
  if (!this->Mesh.Creases.empty())
  {
    this->markCreases();
  }
  this->computePointNormals();
  this->report(0.75);
  this->computeBends();
  this->report(0.95);
}

void PackedMesh::Builder::placeCentre(
  const double* points, const std::int32_t* triangles, std::vector<Part>& parts)
{
  const auto count = static_cast<std::int32_t>(this->PointCount);
  Eigen::AlignedBox3d box;
  for (std::size_t t = 0; t < parts.size(); ++t)
  {
    const std::int32_t* corner = triangles + 3 * t;
    const auto isPoint = [count](std::int32_t i) { return i >= 0 && i < count; };
    if (!std::all_of(corner, corner + 3, isPoint))
    {
      ++this->Mesh.Found.badIndex;
      parts[t] = Part::None;
      continue;
    }
    const auto isWithinReach = [points](std::int32_t i)
    { return (pointAt(points, i).array().abs() <= LargestCoordinate).all(); };
    if (!std::all_of(corner, corner + 3, isWithinReach))
    {
      ++this->Mesh.Found.notFinite;
      parts[t] = Part::None;
      continue;
    }
    for (int k = 0; k < 3; ++k)
    {
      box.extend(pointAt(points, corner[k]));
    }
  }
  if (!box.isEmpty())
  {
    this->Mesh.Centre = 0.5 * box.min() + 0.5 * box.max();
  }
}

void PackedMesh::Builder::roundPoints(const double* points)
{
  this->Coordinates.resize(3 * this->PointCount);
  forRanges(this->PointCount,
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const Vector3 local = pointAt(points, static_cast<std::int32_t>(i)) - this->Mesh.Centre;
        Eigen::Map<Eigen::Vector3f>(this->Coordinates.data() + 3 * i) = local.cast<float>();
      }
    });
}

void PackedMesh::Builder::findParts(
  const double* points, const std::int32_t* triangles, std::vector<Part>& parts)
{
  std::atomic<std::size_t> degenerate{ 0 };
  forRanges(parts.size(),
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t t = first; t < last; ++t)
      {
        if (parts[t] == Part::None)
        {
          continue;
        }
        const std::int32_t* corner = triangles + 3 * t;
        std::array<Vector3, 3> given;
        std::array<Vector3, 3> rounded;
        for (std::size_t k = 0; k < 3; ++k)
        {
          given[k] = pointAt(points, corner[k]);
          rounded[k] = pointAt(this->Coordinates, corner[k]);
        }
        if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0])
        {
          ++degenerate;
          parts[t] = Part::None;
        }
        else if (!keepsItsArea(given, rounded))
        {
          ++degenerate;
          parts[t] = Part::WithoutArea;
        }
      }
    });
  this->Mesh.Found.degenerate = degenerate;
}

void PackedMesh::Builder::orderTriangles(
  const std::int32_t* triangles, const std::vector<Part>& parts)
{
  for (const Part wanted : { Part::Usable, Part::WithoutArea })
  {
    for (std::size_t t = 0; t < parts.size(); ++t)
    {
      if (parts[t] == wanted)
      {
        this->Order.push_back(static_cast<std::int32_t>(t));
      }
    }
    this->Usable = wanted == Part::Usable ? this->Order.size() : this->Usable;
  }
  std::vector<std::int32_t> usable(
    this->Order.begin(), this->Order.begin() + static_cast<std::ptrdiff_t>(this->Usable));
  sortAlongCurve(usable, triangles, this->Coordinates.data());
  std::copy(usable.begin(), usable.end(), this->Order.begin());
}

void PackedMesh::Builder::numberPoints(const std::int32_t* triangles)
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
    const std::int32_t* corner = triangles + 3 * static_cast<std::size_t>(t);
    const std::int32_t a = numberOf(corner[0]);
    const std::int32_t b = numberOf(corner[1]);
    this->Triangles.push_back({ a, b, numberOf(corner[2]) });
  }
  for (std::size_t i = 0; i < this->PointCount; ++i)
  {
    numberOf(static_cast<std::int32_t>(i)); // points of no triangle come last
  }
  std::vector<float> inOrder(this->Coordinates.size());
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    std::copy_n(this->Coordinates.data() + 3 * static_cast<std::size_t>(inputs[i]), 3,
      inOrder.data() + 3 * i);
  }
  this->Coordinates = std::move(inOrder);
  this->Mesh.InputTriangles.assign(
    this->Order.begin(), this->Order.begin() + static_cast<std::ptrdiff_t>(this->Usable));
}

void PackedMesh::Builder::findNeighbours()
{
  this->Links = std::make_unique<TriangleLinks>(this->Triangles, this->PointCount);
  if (this->Links->borderEdges() > 0 || this->Usable < this->Triangles.size())
  {
    this->joinPoints();
  }
  if (this->Links->twistedEdges() > 0)
  {
    this->turnTriangles();
  }
  this->Mesh.Found.nonManifoldEdges = this->Links->nonManifoldEdges();
}

void PackedMesh::Builder::joinPoints()
{
  std::vector<std::int32_t> twins =
    findTwins(this->Coordinates.data(), this->PointCount, *this->Links);
  joinEmptyEdges(this->Coordinates.data(), this->Triangles.data() + this->Usable,
    this->Triangles.data() + this->Triangles.size(), twins);
  for (std::size_t i = 0; i < twins.size(); ++i)
  {
    this->Mesh.Found.joinedPoints += twins[i] != static_cast<std::int32_t>(i);
  }
  if (this->Mesh.Found.joinedPoints == 0)
  {
    return;
  }
  this->Joined = this->Triangles;
  for (TriangleCorners& corners : this->Joined)
  {
    for (std::int32_t& corner : corners)
    {
      corner = twins[static_cast<std::size_t>(corner)];
    }
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
    {
      corners[0] = -1; // without area, and now without a third corner: its neighbours are adjacent
    }
  }
  this->Twins = std::move(twins);
  this->Links = std::make_unique<TriangleLinks>(this->Joined, this->PointCount);
}

void PackedMesh::Builder::turnTriangles()
{
  std::vector<TriangleCorners> turned = this->joined();
  this->Mesh.Found.turnedTriangles = makeWindingConsistent(turned);
  if (this->Mesh.Found.turnedTriangles == 0)
  {
    return;
  }
  for (std::size_t t = 0; t < turned.size(); ++t)
  {
    if (turned[t][1] != this->joined()[t][1])
    {
      std::swap(this->Triangles[t][1], this->Triangles[t][2]);
    }
  }
  this->Links = std::make_unique<TriangleLinks>(turned, this->PointCount);
  if (!this->Joined.empty())
  {
    this->Joined = std::move(turned);
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
    if (this->twinOf(point) == point) // it comes before its twins
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

void PackedMesh::Builder::computePointNormals()
{
  forRanges(this->PointCount,
    [this](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const Vector3 at = pointAt(this->Coordinates, static_cast<std::int32_t>(i));
        const auto self = static_cast<std::int32_t>(this->twinOf(i));
        Vector3 sum = Vector3::Zero();
        this->Mesh.visitAround(static_cast<std::int32_t>(i),
          [&](std::int32_t triangle)
          {
            const TriangleCorners& corners = this->joined()[static_cast<std::size_t>(triangle)];
            const int k = corners[0] == self ? 0 : corners[1] == self ? 1 : 2;
            const Vector3 u = this->Mesh.corner(triangle, (k + 1) % 3) - at;
            const Vector3 v = this->Mesh.corner(triangle, (k + 2) % 3) - at;
            const Vector3 normal = u.cross(v);
            sum += cornerAngle(u, v) / normal.norm() * normal;
          });
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
