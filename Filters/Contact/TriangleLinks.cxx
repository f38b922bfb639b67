// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/TriangleLinks.h"

#include "Contact/ParallelRanges.h"

#include <atomic>

namespace palpate
{
namespace
{
/// Counts of the triangles at the edge from -> to.
struct EdgeFan
{
  int alike = 0;  ///< triangles with the direction from -> to, like the given triangle
  int across = 0; ///< triangles with the direction to -> from
  std::int32_t neighbour = TriangleLinks::Border;
  /// Whether the given triangle is the first one at the edge; used to count an edge only once.
  bool askerIsFirst = true;
};

EdgeFan fanOf(const std::vector<TriangleCorners>& triangles,
  const std::array<const std::int32_t*, 2>& around, std::int32_t asker, std::int32_t from,
  std::int32_t to)
{
  EdgeFan fan;
  for (const std::int32_t* other = around[0]; other != around[1]; ++other)
  {
    const TriangleCorners& corner = triangles[static_cast<std::size_t>(*other)];
    const std::size_t at = corner[0] == from ? 0 : corner[1] == from ? 1 : 2;
    const bool alike = corner[(at + 1) % 3] == to;
    const bool across = corner[(at + 2) % 3] == to;
    fan.alike += alike;
    fan.across += across;
    fan.neighbour = across ? *other : fan.neighbour;
    fan.askerIsFirst = fan.askerIsFirst && !((alike || across) && *other < asker);
  }
  return fan;
}
} // namespace

TriangleLinks::TriangleLinks(const std::vector<TriangleCorners>& triangles, std::size_t pointCount)
  : Neighbours(triangles.size(), { Border, Border, Border })
{
  this->linkPoints(triangles, pointCount);
  this->linkEdges(triangles);
  this->markBorder(triangles, pointCount);
}

void TriangleLinks::linkPoints(
  const std::vector<TriangleCorners>& triangles, std::size_t pointCount)
{
  this->RingStart.assign(pointCount + 1, 0);
  for (const TriangleCorners& corners : triangles)
  {
    for (std::size_t k = 0; k < 3 && corners[0] >= 0; ++k)
    {
      ++this->RingStart[static_cast<std::size_t>(corners[k]) + 1];
    }
  }
  for (std::size_t i = 1; i < this->RingStart.size(); ++i)
  {
    this->RingStart[i] += this->RingStart[i - 1];
  }
  this->Ring.resize(this->RingStart.back());
  std::vector<std::uint32_t> next(this->RingStart.begin(), this->RingStart.end() - 1);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (triangles[t][0] >= 0)
    {
      for (const std::int32_t corner : triangles[t])
      {
        this->Ring[next[static_cast<std::size_t>(corner)]++] = static_cast<std::int32_t>(t);
      }
    }
  }
}

void TriangleLinks::linkEdges(const std::vector<TriangleCorners>& triangles)
{
  std::atomic<std::size_t> border{ 0 };
  std::atomic<std::size_t> nonManifold{ 0 };
  std::atomic<std::size_t> twisted{ 0 };
  forRanges(triangles.size(),
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t t = first; t < last; ++t)
      {
        for (std::size_t e = 0; e < 3 && triangles[t][0] >= 0; ++e)
        {
          const std::int32_t from = triangles[t][e];
          const std::int32_t to = triangles[t][(e + 1) % 3];
          const EdgeFan fan =
            fanOf(triangles, this->around(from), static_cast<std::int32_t>(t), from, to);
          if (fan.alike == 1 && fan.across == 1)
          {
            this->Neighbours[t][e] = fan.neighbour;
            continue;
          }
          const bool single = fan.alike + fan.across == 1;
          this->Neighbours[t][e] = single ? Border : NonManifold;
          border += single;
          nonManifold += !single && fan.askerIsFirst;
          twisted += !single && fan.askerIsFirst && fan.alike == 2 && fan.across == 0;
        }
      }
    });
  this->BorderEdges = border;
  this->NonManifoldEdges = nonManifold;
  this->TwistedEdges = twisted;
}

void TriangleLinks::markBorder(
  const std::vector<TriangleCorners>& triangles, std::size_t pointCount)
{
  this->OnBorder.assign(pointCount, 0);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (std::size_t e = 0; e < 3 && triangles[t][0] >= 0; ++e)
    {
      if (this->Neighbours[t][e] < 0)
      {
        this->OnBorder[static_cast<std::size_t>(triangles[t][e])] = 1;
        this->OnBorder[static_cast<std::size_t>(triangles[t][(e + 1) % 3])] = 1;
      }
    }
  }
}
} // namespace palpate
