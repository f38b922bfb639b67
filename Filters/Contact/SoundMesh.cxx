// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/SoundMesh.h"

#include "Contact/MeshParts.h"
#include "Contact/MeshRepair.h"
#include "Contact/MeshRepeats.h"
#include "Contact/ParallelRanges.h"
#include "Mechanics/JoinedText.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <utility>

namespace palpate
{
namespace
{
/// Largest fraction of the triangles that may be flaps. A larger fraction indicates a sheet with
/// two sides.
constexpr double LargestShareOfFlaps = 0.1;

Vector3 pointAt(const double* points, std::int32_t index)
{
  return Eigen::Map<const Vector3>(points + 3 * static_cast<std::size_t>(index));
}

bool hasCornerTwice(const TriangleCorners& c)
{
  return c[0] == c[1] || c[1] == c[2] || c[2] == c[0];
}

/// Returns whether the rounded triangle still has an area, and its normal the same orientation as
/// that of the given triangle.
bool keepsItsArea(const std::array<Vector3, 3>& given, const std::array<Vector3, 3>& rounded)
{
  const auto normalOf = [](const std::array<Vector3, 3>& t) -> Vector3
  { return (t[1] - t[0]).cross(t[2] - t[0]); };
  const Vector3 normal = normalOf(rounded);
  const double longest = std::max({ (rounded[1] - rounded[0]).squaredNorm(),
    (rounded[2] - rounded[1]).squaredNorm(), (rounded[0] - rounded[2]).squaredNorm() });
  // Differences of floats are exact in double; only the products are rounded.
  return normal.norm() > 4e-16 * longest && normal.dot(normalOf(given)) > 0.0;
}
} // namespace

SoundMesh::SoundMesh(const double* points, std::size_t pointCount, const std::int32_t* triangles,
  std::size_t triangleCount, bool isPiece)
  : PointCount(pointCount)
  , Triangles(triangleCount)
  , WithoutArea(triangleCount, 0)
{
  for (std::size_t t = 0; t < triangleCount; ++t)
  {
    std::copy_n(triangles + 3 * t, 3, this->Triangles[t].begin());
  }
  this->findUsable(points);
  this->roundPoints(points);
  this->findAreas(points);
  this->repair(isPiece);
}

void SoundMesh::findUsable(const double* points)
{
  const auto count = static_cast<std::int32_t>(this->PointCount);
  const auto isPoint = [count](std::int32_t i) { return i >= 0 && i < count; };
  const auto isWithinReach = [points](std::int32_t i)
  { return (pointAt(points, i).array().abs() <= LargestCoordinate).all(); };
  Eigen::AlignedBox3d box;
  for (TriangleCorners& corners : this->Triangles)
  {
    if (!std::all_of(corners.begin(), corners.end(), isPoint))
    {
      ++this->Found.badIndex;
      corners[0] = -1;
    }
    else if (!std::all_of(corners.begin(), corners.end(), isWithinReach))
    {
      ++this->Found.notFinite;
      corners[0] = -1;
    }
    else
    {
      for (const std::int32_t corner : corners)
      {
        box.extend(pointAt(points, corner));
      }
    }
  }
  if (!box.isEmpty())
  {
    this->Centre = 0.5 * box.min() + 0.5 * box.max();
  }
}

void SoundMesh::roundPoints(const double* points)
{
  this->Coordinates.resize(3 * this->PointCount);
  forRanges(this->PointCount,
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const Vector3 local = pointAt(points, static_cast<std::int32_t>(i)) - this->Centre;
        Eigen::Map<Eigen::Vector3f>(this->Coordinates.data() + 3 * i) = local.cast<float>();
      }
    });
}

void SoundMesh::findAreas(const double* points)
{
  std::atomic<std::size_t> degenerate{ 0 };
  forRanges(this->Triangles.size(),
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t t = first; t < last; ++t)
      {
        TriangleCorners& corners = this->Triangles[t];
        if (corners[0] < 0)
        {
          continue;
        }
        std::array<Vector3, 3> given;
        std::array<Vector3, 3> rounded;
        for (std::size_t k = 0; k < 3; ++k)
        {
          given[k] = pointAt(points, corners[k]);
          rounded[k] = Eigen::Map<const Eigen::Vector3f>(
            this->Coordinates.data() + 3 * static_cast<std::size_t>(corners[k]))
                         .cast<double>();
        }
        if (hasCornerTwice(corners))
        {
          ++degenerate;
          corners[0] = -1;
        }
        else if (!keepsItsArea(given, rounded))
        {
          ++degenerate;
          this->WithoutArea[t] = 1;
        }
      }
    });
  this->Found.degenerate = degenerate;
}

void SoundMesh::repair(bool isPiece)
{
  const bool losesArea =
    std::find(this->WithoutArea.begin(), this->WithoutArea.end(), 1) != this->WithoutArea.end();
  std::vector<TriangleCorners> joined = this->Triangles;
  auto links = std::make_unique<TriangleLinks>(joined, this->PointCount);
  const auto link = [&]() { links = std::make_unique<TriangleLinks>(joined, this->PointCount); };
  Repeats repeats;
  const auto merge = [&]()
  {
    const std::size_t before = repeats.copies;
    mergeRepeats(joined, *links, repeats);
    if (repeats.copies > before)
    {
      link();
    }
  };
  // Copies are merged before points are joined, because a copy closes the hole around a triangle
  // with separate points.
  merge();
  if (links->borderEdges() > 0 || losesArea)
  {
    this->joinPoints(*links, joined);
    if (this->hasJoinedPoints())
    {
      link();
      merge();
    }
  }
  dropFlaps(joined, *links, repeats);
  if (2.0 * static_cast<double>(repeats.sheets) >
    LargestShareOfFlaps * static_cast<double>(joined.size()))
  {
    this->Fault = palpate::joined(2 * repeats.sheets, " of ", joined.size(),
      " triangles occur with their reverse, as the two sides of a sheet do: keep one side");
    return;
  }
  if (repeats.flaps > 0)
  {
    link();
  }
  if (links->twistedEdges() > 0 && makeWindingConsistent(joined) > 0)
  {
    link();
  }
  OrientedParts parts;
  if (!isPiece)
  {
    parts = orientParts(this->Coordinates.data(), joined, *links);
    if (parts.hasJoined)
    {
      link();
      this->joinPoints(*links, joined);
      link();
      makeWindingConsistent(joined);
      link();
      parts = orientParts(this->Coordinates.data(), joined, *links);
    }
  }
  this->Fault = std::move(parts.fault);
  this->Found.nonManifoldEdges = links->nonManifoldEdges();
  this->takeOver(joined);
  for (const std::int32_t t : parts.hidden)
  {
    const bool hasArea = this->WithoutArea[static_cast<std::size_t>(t)] == 0;
    this->Found.hiddenTriangles += hasArea;
    this->Found.repeatedTriangles -= hasArea;
  }
}

void SoundMesh::joinPoints(const TriangleLinks& links, std::vector<TriangleCorners>& joined)
{
  std::vector<std::int32_t> first = findTwins(this->Coordinates.data(), this->PointCount, links);
  for (std::size_t t = 0; t < joined.size(); ++t)
  {
    if (this->WithoutArea[t] != 0 && joined[t][0] >= 0)
    {
      joinEmptyEdges(this->Coordinates.data(), joined[t], first);
    }
  }
  followJoints(first);
  for (TriangleCorners& corners : joined)
  {
    if (corners[0] < 0)
    {
      continue;
    }
    for (std::int32_t& corner : corners)
    {
      corner = first[static_cast<std::size_t>(corner)];
    }
    if (hasCornerTwice(corners))
    {
      // The triangle has only two different corners; its neighbours share this edge.
      corners[0] = -1;
    }
  }
  this->Found.joinedPoints = 0;
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    const std::int32_t before = this->firstAt(static_cast<std::int32_t>(i));
    first[i] = first[static_cast<std::size_t>(before)];
    this->Found.joinedPoints += first[i] != static_cast<std::int32_t>(i);
  }
  if (this->Found.joinedPoints > 0)
  {
    this->First = std::move(first);
  }
}

void SoundMesh::takeOver(const std::vector<TriangleCorners>& repaired)
{
  for (std::size_t t = 0; t < repaired.size(); ++t)
  {
    TriangleCorners& corners = this->Triangles[t];
    if (corners[0] < 0)
    {
      continue;
    }
    if (repaired[t][0] < 0)
    {
      corners[0] = -1;
      this->Found.repeatedTriangles += this->WithoutArea[t] == 0;
    }
    else if (this->firstAt(corners[1]) != repaired[t][1])
    {
      std::swap(corners[1], corners[2]);
      ++this->Found.turnedTriangles;
    }
  }
}
} // namespace palpate
