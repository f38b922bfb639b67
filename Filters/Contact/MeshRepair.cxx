// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/MeshRepair.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <utility>

namespace palpate
{
namespace
{
/// One side of an edge, with the direction given by the winding of its triangle.
struct EdgeUse
{
  std::int32_t low;
  std::int32_t high;
  std::int32_t triangle;
  /// Whether the side runs from the point with the lower index to that with the higher index.
  bool rising;
};

struct Link
{
  std::int32_t other;
  bool agrees;
};

/// For each edge of each triangle: the other triangle at the edge, or -1 if the edge does not have
/// exactly two triangles.
std::vector<std::array<Link, 3>> linkByEdges(const std::vector<TriangleCorners>& triangles)
{
  std::vector<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (std::size_t e = 0; e < 3 && triangles[t][0] >= 0; ++e)
    {
      const std::int32_t from = triangles[t][e];
      const std::int32_t to = triangles[t][(e + 1) % 3];
      uses.push_back(
        { std::min(from, to), std::max(from, to), static_cast<std::int32_t>(t), from < to });
    }
  }
  std::sort(uses.begin(), uses.end(),
    [](const EdgeUse& a, const EdgeUse& b)
    { return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle); });

  std::vector<std::array<Link, 3>> links(
    triangles.size(), { Link{ -1, true }, Link{ -1, true }, Link{ -1, true } });
  const auto attach = [&links](const EdgeUse& use, const EdgeUse& other)
  {
    auto& three = links[static_cast<std::size_t>(use.triangle)];
    *std::find_if(three.begin(), three.end(), [](const Link& link) { return link.other < 0; }) = {
      other.triangle, use.rising != other.rising
    };
  };
  for (std::size_t first = 0; first < uses.size();)
  {
    std::size_t last = first + 1;
    while (last < uses.size() && uses[last].low == uses[first].low &&
      uses[last].high == uses[first].high)
    {
      ++last;
    }
    if (last - first == 2)
    {
      attach(uses[first], uses[first + 1]);
      attach(uses[first + 1], uses[first]);
    }
    first = last;
  }
  return links;
}
} // namespace

std::size_t makeWindingConsistent(std::vector<TriangleCorners>& triangles)
{
  const std::vector<std::array<Link, 3>> links = linkByEdges(triangles);
  enum : std::uint8_t
  {
    Unseen,
    Kept,
    Turned
  };
  std::vector<std::uint8_t> state(triangles.size(), Unseen);
  std::vector<std::int32_t> part;
  std::size_t turned = 0;
  for (std::size_t seed = 0; seed < triangles.size(); ++seed)
  {
    if (state[seed] != Unseen)
    {
      continue;
    }
    part.assign(1, static_cast<std::int32_t>(seed));
    state[seed] = Kept;
    bool agree = true;
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      const auto at = static_cast<std::size_t>(part[i]);
      for (const Link& link : links[at])
      {
        if (link.other < 0)
        {
          continue;
        }
        std::uint8_t& other = state[static_cast<std::size_t>(link.other)];
        const std::uint8_t wanted = (state[at] == Kept) == link.agrees ? Kept : Turned;
        if (other == Unseen)
        {
          other = wanted;
          part.push_back(link.other);
        }
        agree = agree && other == wanted;
      }
    }
    const auto inTurned = static_cast<std::size_t>(std::count_if(part.begin(), part.end(),
      [&state](std::int32_t t) { return state[static_cast<std::size_t>(t)] == Turned; }));
    const std::uint8_t fewer = 2 * inTurned <= part.size() ? Turned : Kept;
    for (const std::int32_t t : part)
    {
      if (agree && state[static_cast<std::size_t>(t)] == fewer)
      {
        std::swap(
          triangles[static_cast<std::size_t>(t)][1], triangles[static_cast<std::size_t>(t)][2]);
        ++turned;
      }
    }
  }
  return turned;
}

std::vector<std::int32_t> findTwins(
  const float* coordinates, std::size_t pointCount, const TriangleLinks& links)
{
  std::vector<std::int32_t> first(pointCount);
  std::iota(first.begin(), first.end(), 0);
  std::vector<std::int32_t> border;
  std::copy_if(first.begin(), first.end(), std::back_inserter(border),
    [&links](std::int32_t point) { return links.onBorder(point); });
  const auto place = [coordinates](std::int32_t point)
  {
    const float* p = coordinates + 3 * static_cast<std::size_t>(point);
    return std::make_tuple(p[0], p[1], p[2]);
  };
  std::sort(border.begin(), border.end(),
    [&place](std::int32_t a, std::int32_t b)
    { return std::make_pair(place(a), a) < std::make_pair(place(b), b); });
  for (std::size_t i = 1; i < border.size(); ++i)
  {
    if (place(border[i]) == place(border[i - 1]))
    {
      first[static_cast<std::size_t>(border[i])] = first[static_cast<std::size_t>(border[i - 1])];
    }
  }
  return first;
}

void joinEmptyEdges(
  const float* coordinates, const TriangleCorners& corners, std::vector<std::int32_t>& first)
{
  const auto firstOf = [&first](std::int32_t point)
  {
    while (first[static_cast<std::size_t>(point)] != point)
    {
      point = first[static_cast<std::size_t>(point)];
    }
    return point;
  };
  const auto atOnePlace = [coordinates](std::int32_t a, std::int32_t b)
  {
    const float* p = coordinates + 3 * static_cast<std::size_t>(a);
    return std::equal(p, p + 3, coordinates + 3 * static_cast<std::size_t>(b));
  };
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (atOnePlace(corners[k], corners[(k + 1) % 3]))
    {
      const std::int32_t a = firstOf(corners[k]);
      const std::int32_t b = firstOf(corners[(k + 1) % 3]);
      first[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
  }
}

void followJoints(std::vector<std::int32_t>& first)
{
  // First[point] <= point; the entry at first[point] is already final.
  for (std::int32_t& point : first)
  {
    point = first[static_cast<std::size_t>(point)];
  }
}
} // namespace palpate
