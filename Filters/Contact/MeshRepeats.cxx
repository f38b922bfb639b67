// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/MeshRepeats.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace palpate
{
namespace
{
struct Entry
{
  TriangleCorners ascending;
  std::int32_t triangle;
  bool isEven; ///< whether an even permutation sorts the triangle's corners in ascending order

  bool operator<(const Entry& other) const
  {
    return std::tie(this->ascending, this->triangle) < std::tie(other.ascending, other.triangle);
  }
};

Entry entryOf(const TriangleCorners& corners, std::size_t triangle)
{
  Entry made{ corners, static_cast<std::int32_t>(triangle), true };
  for (const auto& [low, high] : { std::pair(0U, 1U), std::pair(1U, 2U), std::pair(0U, 1U) })
  {
    if (made.ascending[low] > made.ascending[high])
    {
      std::swap(made.ascending[low], made.ascending[high]);
      made.isEven = !made.isEven;
    }
  }
  return made;
}

/// Returns the triangles at edges with more than two triangles, and pairs that share all three
/// edges. Any copy of a triangle is among these triangles.
std::vector<Entry> candidates(
  const std::vector<TriangleCorners>& triangles, const TriangleLinks& links)
{
  std::vector<Entry> found;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const auto& three = links.neighbours(t);
    const bool isPair = three[0] >= 0 && three[0] == three[1] && three[1] == three[2];
    if (triangles[t][0] >= 0 &&
      (isPair || std::find(three.begin(), three.end(), TriangleLinks::NonManifold) != three.end()))
    {
      found.push_back(entryOf(triangles[t], t));
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

using Edge = std::pair<std::int32_t, std::int32_t>;
Edge edgeOf(const TriangleCorners& corners, std::size_t e)
{
  return std::minmax(corners[e], corners[(e + 1) % 3]);
}

/// Patches of triangles that also occur with the reverse winding; one triangle of each pair is in
/// `doubtful`.
class Patches
{
public:
  Patches(std::vector<TriangleCorners>& triangles, const TriangleLinks& links,
    const std::set<std::int32_t>& doubtful)
    : Triangles(triangles)
    , Links(links)
    , Doubtful(doubtful)
  {
    for (const std::int32_t t : doubtful)
    {
      for (std::size_t e = 0; e < 3; ++e)
      {
        this->AtEdge[edgeOf(this->corners(t), e)].push_back(t);
      }
    }
  }

  /// Leaves out the patches that do not fill a hole.
  void dropFlaps(Repeats& repeats)
  {
    std::set<std::int32_t> seen;
    for (const std::int32_t seed : this->Doubtful)
    {
      if (!seen.insert(seed).second)
      {
        continue;
      }
      std::vector<std::int32_t> patch{ seed };
      // Number of edges with exactly one other triangle, minus the number of all other edges.
      int filled = 0;
      // Number of edges with several other triangles, minus the number of edges with none.
      int walled = 0;
      for (std::size_t i = 0; i < patch.size(); ++i)
      {
        const TriangleCorners corners = this->corners(patch[i]);
        for (std::size_t e = 0; e < 3; ++e)
        {
          const std::vector<std::int32_t>& own = this->AtEdge[edgeOf(corners, e)];
          if (own.size() == 1)
          {
            const std::ptrdiff_t others = this->othersAt(edgeOf(corners, e));
            filled += others == 1 ? 1 : -1;
            walled += others > 1 ? 1 : others == 0 ? -1 : 0;
          }
          std::copy_if(own.begin(), own.end(), std::back_inserter(patch),
            [&seen](std::int32_t t) { return seen.insert(t).second; });
        }
      }
      for (const std::int32_t t : patch)
      {
        this->Triangles[static_cast<std::size_t>(t)][0] = filled > 0 ? this->corners(t)[0] : -1;
      }
      const std::size_t dropped = filled > 0 ? 0 : patch.size();
      repeats.flaps += dropped;
      repeats.sheets += walled > 0 ? 0 : dropped;
    }
  }

private:
  const TriangleCorners& corners(std::int32_t triangle) const
  {
    return this->Triangles[static_cast<std::size_t>(triangle)];
  }
  /// Number of triangles at an edge that are not in `doubtful`.
  std::ptrdiff_t othersAt(const Edge& edge) const
  {
    const auto around = this->Links.around(edge.first);
    return std::count_if(around[0], around[1],
      [&](std::int32_t t)
      {
        const TriangleCorners& corners = this->corners(t);
        return corners[0] >= 0 && this->Doubtful.count(t) == 0 &&
          std::find(corners.begin(), corners.end(), edge.second) != corners.end();
      });
  }

  std::vector<TriangleCorners>& Triangles;
  const TriangleLinks& Links;
  const std::set<std::int32_t>& Doubtful;
  std::map<Edge, std::vector<std::int32_t>> AtEdge;
};
} // namespace

void mergeRepeats(
  std::vector<TriangleCorners>& triangles, const TriangleLinks& links, Repeats& repeats)
{
  const std::vector<Entry> all = candidates(triangles, links);
  for (auto first = all.begin(); first != all.end();)
  {
    const auto last = std::find_if(first, all.end(),
      [&first](const Entry& other) { return other.ascending != first->ascending; });
    for (auto copy = first + 1; copy != last; ++copy)
    {
      triangles[static_cast<std::size_t>(copy->triangle)][0] = -1;
      ++repeats.copies;
      if (copy->isEven != first->isEven || repeats.doubtful.count(copy->triangle) > 0)
      {
        repeats.doubtful.insert(first->triangle);
      }
      repeats.doubtful.erase(copy->triangle);
    }
    first = last;
  }
}

void dropFlaps(
  std::vector<TriangleCorners>& triangles, const TriangleLinks& links, Repeats& repeats)
{
  // A doubtful triangle may have been removed when points were joined.
  for (auto each = repeats.doubtful.begin(); each != repeats.doubtful.end();)
  {
    const bool isLeftOut = triangles[static_cast<std::size_t>(*each)][0] < 0;
    each = isLeftOut ? repeats.doubtful.erase(each) : std::next(each);
  }
  if (!repeats.doubtful.empty())
  {
    Patches(triangles, links, repeats.doubtful).dropFlaps(repeats);
  }
}
} // namespace palpate
