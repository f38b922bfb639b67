// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/TwinParts.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <string_view>
#include <utility>

namespace palpate
{
namespace
{
/// Two triangles whose corners have the same coordinates.
struct TwinTriangles
{
  std::int32_t first;
  std::int32_t second;
  bool areReversed; ///< whether they are wound in opposite directions
};

/// Pairs each triangle of `candidates` with the first triangle that has the same coordinates.
std::vector<TwinTriangles> findTwinTriangles(const float* coordinates,
  const std::vector<TriangleCorners>& triangles, const std::vector<std::int32_t>& candidates)
{
  using Place = std::array<float, 3>;
  const auto placeOf = [coordinates](std::int32_t point)
  {
    const float* p = coordinates + 3 * static_cast<std::size_t>(point);
    return Place{ p[0] + 0.0F, p[1] + 0.0F, p[2] + 0.0F }; // adding 0 changes -0 to 0
  };
  // Returns the coordinates of the corners in ascending order, and whether an even permutation
  // sorts the corners.
  const auto placesOf = [&](std::int32_t t)
  {
    const TriangleCorners& corners = triangles[static_cast<std::size_t>(t)];
    std::array<Place, 3> places{ placeOf(corners[0]), placeOf(corners[1]), placeOf(corners[2]) };
    bool isEven = true;
    for (const auto& [low, high] : { std::pair(0U, 1U), std::pair(1U, 2U), std::pair(0U, 1U) })
    {
      if (places[low] > places[high])
      {
        std::swap(places[low], places[high]);
        isEven = !isEven;
      }
    }
    return std::pair(places, isEven);
  };
  std::vector<std::pair<std::size_t, std::int32_t>> order; // (hash, triangle), sorted by hash
  order.reserve(candidates.size());
  for (const std::int32_t t : candidates)
  {
    const auto places = placesOf(t).first;
    const std::string_view bytes(reinterpret_cast<const char*>(places.data()), sizeof(places));
    order.emplace_back(std::hash<std::string_view>()(bytes), t);
  }
  std::sort(order.begin(), order.end());
  std::vector<TwinTriangles> twins;
  for (std::size_t first = 0; first < order.size();)
  {
    std::size_t last = first + 1;
    for (; last < order.size() && order[last].first == order[first].first; ++last)
    {
      const auto one = placesOf(order[first].second);
      const auto other = placesOf(order[last].second);
      if (one.first == other.first)
      {
        twins.push_back({ order[first].second, order[last].second, one.second != other.second });
      }
    }
    first = last;
  }
  return twins;
}

class Twins
{
public:
  Twins(const float* coordinates, std::vector<TriangleCorners>& triangles,
    const std::vector<std::int32_t>& order, const std::vector<MeshPart>& parts)
    : Triangles(triangles)
    , Order(order)
    , Parts(parts)
    , PartOf(triangles.size(), 0)
    , IsCopy(parts.size(), false)
  {
    std::vector<std::int32_t> candidates;
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      for (std::size_t k = parts[i].first; k < parts[i].first + parts[i].count; ++k)
      {
        this->PartOf[static_cast<std::size_t>(order[k])] = i;
        if (triangles[static_cast<std::size_t>(order[k])][0] >= 0)
        {
          candidates.push_back(order[k]);
        }
      }
    }
    for (const TwinTriangles& pair : findTwinTriangles(coordinates, triangles, candidates))
    {
      if (this->partOf(pair.first) != this->partOf(pair.second))
      {
        this->Pairs.push_back(pair);
      }
    }
  }

  /// Leaves out copies. A part is a copy if each of its triangles has a twin in one other part. Of
  /// two equal parts, the later one is the copy.
  void dropCopies()
  {
    // Number of twins by earlier and later part.
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> shared;
    for (const TwinTriangles& pair : this->Pairs)
    {
      ++shared[std::minmax({ this->partOf(pair.first), this->partOf(pair.second) })];
    }
    for (const auto& [parts, count] : shared)
    {
      const auto [earlier, later] = parts;
      const std::size_t copy = count >= this->Parts[later].count ? later : earlier;
      if (count < this->Parts[copy].count || this->IsCopy[earlier] || this->IsCopy[later])
      {
        continue;
      }
      this->IsCopy[copy] = true;
      for (std::size_t k = 0; k < this->Parts[copy].count; ++k)
      {
        this->drop(this->Order[this->Parts[copy].first + k]);
      }
    }
  }

  std::vector<std::int32_t> walls() const
  {
    std::vector<std::int32_t> found;
    for (const TwinTriangles& pair : this->Pairs)
    {
      if (pair.areReversed && this->isSolid(pair.first) && this->isSolid(pair.second))
      {
        found.push_back(pair.first);
        found.push_back(pair.second);
      }
    }
    return found;
  }

private:
  std::size_t partOf(std::int32_t triangle) const
  {
    return this->PartOf[static_cast<std::size_t>(triangle)];
  }
  bool isSolid(std::int32_t triangle) const
  {
    return this->Parts[this->partOf(triangle)].isSolid && !this->IsCopy[this->partOf(triangle)];
  }
  void drop(std::int32_t triangle) { this->Triangles[static_cast<std::size_t>(triangle)][0] = -1; }

  std::vector<TriangleCorners>& Triangles;
  const std::vector<std::int32_t>& Order;
  const std::vector<MeshPart>& Parts;
  std::vector<std::size_t> PartOf; ///< index of the part of each triangle
  std::vector<TwinTriangles> Pairs;
  std::vector<bool> IsCopy; ///< one value for each part
};
} // namespace

std::vector<std::int32_t> dropCopiedParts(const float* coordinates,
  std::vector<TriangleCorners>& triangles, const std::vector<std::int32_t>& order,
  const std::vector<MeshPart>& parts)
{
  Twins twins(coordinates, triangles, order, parts);
  twins.dropCopies();
  return twins.walls();
}
} // namespace palpate
