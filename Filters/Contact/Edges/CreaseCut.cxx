// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/Edges/CreaseCut.h"

#include "Contact/ParallelRanges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace palpate
{
namespace
{
constexpr double TimesItsFellows = 2.0;
constexpr double LeastFold = 0.75;     // rad, 43°: round bodies of few facets turn by less
constexpr double TimesFlatFaces = 5.0; // a surface with flat faces, not a scan of a round body

Vector3 pointAt(const std::vector<float>& points, std::int32_t index)
{
  return Eigen::Map<const Eigen::Vector3f>(points.data() + 3 * static_cast<std::size_t>(index))
    .cast<double>();
}
} // namespace

CreaseCut::CreaseCut(const std::vector<TriangleCorners>& triangles, std::size_t usable,
  const std::vector<float>& coordinates, const TriangleLinks& links, double leastTurn)
  : Triangles(triangles)
  , Links(links)
  , IsCut(3 * triangles.size())
  , Parts(3 * triangles.size())
{
  this->findSides(usable, coordinates, leastTurn);
  std::vector<std::int32_t> ends;
  for (const PackedMesh::CreaseSide& side : this->Sides)
  {
    // The end of this side is the start of the side in the other triangle.
    ends.push_back(this->Triangles[static_cast<std::size_t>(side.triangle)]
                                  [static_cast<std::size_t>(side.edge)]);
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  for (const std::int32_t point : ends)
  {
    this->partAround(point);
  }
  this->dropUncut();
}

void CreaseCut::findSides(
  std::size_t usable, const std::vector<float>& coordinates, double leastTurn)
{
  std::vector<Vector3> normals(usable);
  // Angle between the normals across each edge, rad; negative for a concave edge.
  std::vector<std::array<float, 3>> turns(usable);
  forRanges(usable,
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t t = first; t < last; ++t)
      {
        const TriangleCorners& c = this->Triangles[t];
        const Vector3 a = pointAt(coordinates, c[0]);
        normals[t] =
          (pointAt(coordinates, c[1]) - a).cross(pointAt(coordinates, c[2]) - a).normalized();
      }
    });
  forRanges(usable,
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t t = first; t < last; ++t)
      {
        for (std::size_t e = 0; e < 3; ++e)
        {
          const std::int32_t across = this->Links.neighbours(t)[e];
          turns[t][e] = 0.0F;
          if (across < 0 || static_cast<std::size_t>(across) >= usable)
          {
            continue;
          }
          const Vector3& other = normals[static_cast<std::size_t>(across)];
          const Vector3 along = pointAt(coordinates, this->Triangles[t][(e + 1) % 3]) -
            pointAt(coordinates, this->Triangles[t][e]);
          const Vector3 turning = normals[t].cross(other);
          const double turn = std::atan2(turning.norm(), normals[t].dot(other));
          turns[t][e] = static_cast<float>(turning.dot(along) < 0.0 ? -turn : turn);
        }
      }
    });
  const auto leastOf = [&](std::size_t t, std::size_t but)
  { return std::min(std::abs(turns[t][(but + 1) % 3]), std::abs(turns[t][(but + 2) % 3])); };
  for (std::size_t t = 0; t < usable; ++t)
  {
    for (std::size_t e = 0; e < 3; ++e)
    {
      const double turn{ turns[t][e] };
      if (std::abs(turn) < leastTurn)
      {
        continue;
      }
      const std::int32_t across = this->Links.neighbours(t)[e];
      const auto n = static_cast<std::size_t>(across);
      const auto& back = this->Links.neighbours(n);
      const auto f = static_cast<std::size_t>(
        std::find(back.begin(), back.end(), static_cast<std::int32_t>(t)) - back.begin());
      const double beside{ std::max(leastOf(t, e), leastOf(n, f)) };
      const PackedMesh::CreaseSide side{ static_cast<std::int32_t>(t), static_cast<std::int32_t>(e),
        across, turns[t][e] };
      if (turn >= PackedMesh::BluntTurn || turn >= TimesItsFellows * beside)
      {
        this->IsCut[3 * t + e] = 1;
        this->Sides.push_back(side);
      }
      if (std::abs(turn) >= std::max(LeastFold, TimesFlatFaces * beside))
      {
        this->Folds.push_back(side);
      }
    }
  }
}

std::size_t CreaseCut::cornerOf(std::size_t triangle, std::int32_t point) const
{
  const TriangleCorners& corners = this->Triangles[triangle];
  return corners[0] == point ? 0 : corners[1] == point ? 1 : 2;
}

void CreaseCut::partAround(std::int32_t point)
{
  constexpr int unseen = -1;
  const auto around = this->Links.around(point);
  for (const std::int32_t* t = around[0]; t != around[1]; ++t)
  {
    const auto at = static_cast<std::size_t>(*t);
    this->Parts[3 * at + this->cornerOf(at, point)] = unseen;
  }
  int parts = 0;
  std::vector<std::size_t> open;
  for (const std::int32_t* t = around[0]; t != around[1]; ++t)
  {
    open.assign(1, static_cast<std::size_t>(*t));
    bool isNew = false;
    while (!open.empty())
    {
      const std::size_t at = open.back();
      open.pop_back();
      const std::size_t corner = this->cornerOf(at, point);
      if (this->Parts[3 * at + corner] != unseen)
      {
        continue;
      }
      this->Parts[3 * at + corner] = parts;
      isNew = true;
      for (const std::size_t edge : { corner, (corner + 2) % 3 })
      {
        const std::int32_t across = this->Links.neighbours(at)[edge];
        if (across >= 0 && this->IsCut[3 * at + edge] == 0)
        {
          open.push_back(static_cast<std::size_t>(across));
        }
      }
    }
    parts += isNew ? 1 : 0;
  }
}

std::vector<std::uint8_t> CreaseCut::folded(bool isCut) const
{
  const auto endsOf = [this](const PackedMesh::CreaseSide& side)
  {
    const TriangleCorners& corners = this->Triangles[static_cast<std::size_t>(side.triangle)];
    const auto edge = static_cast<std::size_t>(side.edge);
    return std::array<std::int32_t, 2>{ corners[edge], corners[(edge + 1) % 3] };
  };
  std::unordered_map<std::int32_t, int> sidesAt; // number of sides that end at each point
  for (const PackedMesh::CreaseSide& side : this->Folds)
  {
    for (const std::int32_t point : endsOf(side))
    {
      ++sidesAt[point];
    }
  }
  constexpr int sidesOfOneEdge = 2;
  std::vector<std::uint8_t> folded;
  for (const PackedMesh::CreaseSide& side : this->Folds)
  {
    const auto [start, end] = endsOf(side);
    const bool goesOn = std::min(sidesAt[start], sidesAt[end]) > sidesOfOneEdge;
    if (!goesOn || (isCut && side.turn > 0.0F))
    {
      continue;
    }
    folded.resize(this->Triangles.size());
    for (const std::int32_t point : { start, end })
    {
      const auto around = this->Links.around(point);
      std::for_each(around[0], around[1],
        [&folded](std::int32_t triangle) { folded[static_cast<std::size_t>(triangle)] = 1; });
    }
  }
  return folded;
}

/// Removes edges at which the surface is still connected, because both sides have the same part at
/// both ends.
void CreaseCut::dropUncut()
{
  const auto isWhole = [this](const PackedMesh::CreaseSide& side)
  {
    const auto t = static_cast<std::size_t>(side.triangle);
    const auto n = static_cast<std::size_t>(side.across);
    for (const std::size_t k :
      { static_cast<std::size_t>(side.edge), static_cast<std::size_t>(side.edge + 1) % 3 })
    {
      if (this->part(t, k) != this->part(n, this->cornerOf(n, this->Triangles[t][k])))
      {
        return false;
      }
    }
    return true;
  };
  this->Sides.erase(
    std::remove_if(this->Sides.begin(), this->Sides.end(), isWhole), this->Sides.end());
}
} // namespace palpate
