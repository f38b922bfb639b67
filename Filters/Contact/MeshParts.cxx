// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/MeshParts.h"

#include "Contact/TriangleColumns.h"
#include "Mechanics/JoinedText.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace palpate
{
namespace
{
constexpr double LargestCaps = 0.25; ///< of a solid's area
constexpr double LargestScrap = 0.1; ///< of the whole area
constexpr double LeastVolume = 1e-9; ///< of area^1.5: a sheet of 1 µm by 1 m has more
constexpr std::size_t Samples = 8; ///< triangles of a part that are tried for being inside another

struct Part
{
  std::size_t first; ///< of its triangles, in Parts::Order
  std::size_t count;
  double area = 0.0;   ///< mm²
  double volume = 0.0; ///< mm³, with caps over its holes
  double caps = 0.0;   ///< mm², their area
  Eigen::AlignedBox3d box = {};

  bool isSolid() const { return this->caps <= LargestCaps * this->area; }
  bool isEmpty() const
  {
    return this->isSolid() &&
      std::abs(this->volume) <= LeastVolume * this->area * std::sqrt(this->area);
  }
};

/// Open edges of a part, joined to loops by their points.
class Loops
{
public:
  void add(std::int32_t from, std::int32_t to)
  {
    this->Edges.push_back({ from, to });
    const std::int32_t one = this->rootOf(from);
    this->Above[one] = this->rootOf(to);
  }
  /// Calls visit(from, to, centre of the loop) for each edge.
  template <class Place, class Visit>
  void visit(const Place& place, const Visit& visit)
  {
    struct Sum
    {
      Vector3 moment = Vector3::Zero();
      double length = 0.0;
    };
    std::unordered_map<std::int32_t, Sum> sums;
    for (const auto& [from, to] : this->Edges)
    {
      const double length = (place(to) - place(from)).norm();
      Sum& sum = sums[this->rootOf(from)];
      sum.moment += 0.5 * length * (place(from) + place(to));
      sum.length += length;
    }
    for (const auto& [from, to] : this->Edges)
    {
      const Sum& sum = sums[this->rootOf(from)];
      visit(from, to, sum.length > 0.0 ? Vector3(sum.moment / sum.length) : place(from));
    }
  }

private:
  std::int32_t rootOf(std::int32_t point)
  {
    this->Above.emplace(point, point);
    while (this->Above[point] != point)
    {
      point = this->Above[point] = this->Above[this->Above[point]];
    }
    return point;
  }

  std::vector<std::pair<std::int32_t, std::int32_t>> Edges;
  std::unordered_map<std::int32_t, std::int32_t> Above;
};

class Parts
{
public:
  Parts(
    const float* coordinates, std::vector<TriangleCorners>& triangles, const TriangleLinks& links)
    : Coordinates(coordinates)
    , Triangles(triangles)
    , Links(links)
  {
    this->findParts();
    for (Part& part : this->All)
    {
      this->measure(part);
    }
  }

  OrientedParts orient()
  {
    OrientedParts result;
    this->dropEmptyParts(result);
    if (!result.fault.empty())
    {
      return result;
    }
    const std::vector<std::vector<std::size_t>> around = this->findContainers();
    for (std::size_t i = 0; i < this->All.size(); ++i)
    {
      const Part& part = this->All[i];
      if (!part.isSolid() || part.isEmpty())
      {
        continue;
      }
      const bool isInside = around[i].size() % 2 == 1;
      if (isInside && part.volume > 0.0)
      {
        result.fault = this->name(i) + " lies inside " + this->name(around[i].front()) +
          " and winds outward, as a second body in the same place: remove it, or reverse its "
          "triangles if it is a cavity";
        return result;
      }
      if (!isInside && part.volume < 0.0)
      {
        result.turned += part.count;
        this->forTriangles(
          part, [](TriangleCorners& corners) { std::swap(corners[1], corners[2]); });
      }
    }
    return result;
  }

private:
  Vector3 place(std::int32_t point) const
  {
    return Eigen::Map<const Eigen::Vector3f>(
      this->Coordinates + 3 * static_cast<std::size_t>(point))
      .cast<double>();
  }
  std::array<Vector3, 3> placesOf(const TriangleCorners& corners) const
  {
    return { this->place(corners[0]), this->place(corners[1]), this->place(corners[2]) };
  }
  template <class Visit>
  void forTriangles(const Part& part, const Visit& visit) const
  {
    for (std::size_t i = part.first; i < part.first + part.count; ++i)
    {
      visit(this->Triangles[static_cast<std::size_t>(this->Order[i])]);
    }
  }

  void findParts()
  {
    std::vector<bool> isSeen(this->Triangles.size(), false);
    this->Order.reserve(this->Triangles.size());
    for (std::size_t seed = 0; seed < this->Triangles.size(); ++seed)
    {
      if (isSeen[seed] || this->Triangles[seed][0] < 0)
      {
        continue;
      }
      const std::size_t first = this->Order.size();
      this->Order.push_back(static_cast<std::int32_t>(seed));
      isSeen[seed] = true;
      for (std::size_t i = first; i < this->Order.size(); ++i)
      {
        for (const std::int32_t other :
          this->Links.neighbours(static_cast<std::size_t>(this->Order[i])))
        {
          if (other >= 0 && !isSeen[static_cast<std::size_t>(other)])
          {
            isSeen[static_cast<std::size_t>(other)] = true;
            this->Order.push_back(other);
          }
        }
      }
      this->All.push_back({ first, this->Order.size() - first });
    }
  }

  void measure(Part& part) const
  {
    const Vector3 origin =
      this->place(this->Triangles[static_cast<std::size_t>(this->Order[part.first])][0]);
    const auto volumeOf = [&origin](const Vector3& a, const Vector3& b, const Vector3& c)
    { return (a - origin).dot((b - origin).cross(c - origin)) / 6.0; };
    Loops loops;
    for (std::size_t i = part.first; i < part.first + part.count; ++i)
    {
      const auto t = static_cast<std::size_t>(this->Order[i]);
      const TriangleCorners& corners = this->Triangles[t];
      const auto [a, b, c] = this->placesOf(corners);
      part.area += 0.5 * (b - a).cross(c - a).norm();
      part.volume += volumeOf(a, b, c);
      part.box.extend(a).extend(b).extend(c);
      for (std::size_t e = 0; e < 3; ++e)
      {
        if (this->Links.neighbours(t)[e] < 0)
        {
          loops.add(corners[e], corners[(e + 1) % 3]);
        }
      }
    }
    loops.visit([this](std::int32_t point) { return this->place(point); },
      [&](std::int32_t from, std::int32_t to, const Vector3& centre)
      {
        const Vector3 a = this->place(from);
        const Vector3 b = this->place(to);
        part.volume += volumeOf(b, a, centre);
        part.caps += 0.5 * (a - centre).cross(b - centre).norm();
      });
  }

  void dropEmptyParts(OrientedParts& result)
  {
    double whole = 0.0;
    for (const Part& part : this->All)
    {
      whole += part.area;
    }
    for (std::size_t i = 0; i < this->All.size(); ++i)
    {
      const Part& part = this->All[i];
      if (!part.isEmpty())
      {
        continue;
      }
      if (part.area > LargestScrap * whole)
      {
        result.fault = this->name(i) +
          " encloses no volume, as a sheet whose two sides are at the same place: "
          "keep one side";
        return;
      }
      result.leftOut += part.count;
      this->forTriangles(part, [](TriangleCorners& corners) { corners[0] = -1; });
    }
  }

  /// For each part, the solids that it lies inside.
  std::vector<std::vector<std::size_t>> findContainers() const
  {
    std::vector<std::vector<std::size_t>> around(this->All.size());
    std::vector<std::size_t> solids;
    for (std::size_t i = 0; i < this->All.size(); ++i)
    {
      if (this->All[i].isSolid() && !this->All[i].isEmpty())
      {
        solids.push_back(i);
      }
    }
    if (solids.size() < 2)
    {
      return around;
    }
    // Larger boxes first: those after a box can lie inside it.
    std::sort(solids.begin(), solids.end(),
      [this](std::size_t a, std::size_t b)
      { return this->All[a].box.volume() > this->All[b].box.volume(); });
    std::vector<std::size_t> outer;
    for (const std::size_t i : solids)
    {
      std::vector<std::size_t> candidates;
      std::copy_if(outer.begin(), outer.end(), std::back_inserter(candidates),
        [&](std::size_t o) { return this->All[o].box.contains(this->All[i].box); });
      for (const std::size_t o : candidates)
      {
        if (this->isInside(this->All[i], this->columnsOf(o)))
        {
          around[i].push_back(o);
        }
      }
      outer.push_back(i);
    }
    return around;
  }

  const TriangleColumns& columnsOf(std::size_t part) const
  {
    const auto found = this->Columns.find(part);
    if (found != this->Columns.end())
    {
      return found->second;
    }
    TriangleColumns columns(this->All[part].box, this->All[part].count);
    this->forTriangles(this->All[part],
      [&](const TriangleCorners& corners) { columns.add(this->placesOf(corners)); });
    return this->Columns.emplace(part, std::move(columns)).first->second;
  }

  bool isInside(const Part& part, const TriangleColumns& outer) const
  {
    const std::size_t step = std::max<std::size_t>(1, part.count / Samples);
    for (std::size_t i = 0; i < part.count; i += step)
    {
      const auto t = static_cast<std::size_t>(this->Order[part.first + i]);
      const auto [a, b, c] = this->placesOf(this->Triangles[t]);
      // No symmetric place: a ray from there passes through no edge of a regular mesh.
      if (outer.crossingsAbove(0.3142 * a + 0.3673 * b + 0.3185 * c) % 2 == 0)
      {
        return false;
      }
    }
    return true;
  }

  std::string name(std::size_t part) const
  {
    return joined("part ", part + 1, " of ", this->All.size(), " (", this->All[part].count,
      " triangles, the first is ", this->Order[this->All[part].first], ")");
  }

  const float* Coordinates;
  std::vector<TriangleCorners>& Triangles;
  const TriangleLinks& Links;
  std::vector<std::int32_t> Order; ///< triangles, part by part
  std::vector<Part> All;
  mutable std::unordered_map<std::size_t, TriangleColumns> Columns;
};
} // namespace

OrientedParts orientParts(
  const float* coordinates, std::vector<TriangleCorners>& triangles, const TriangleLinks& links)
{
  return Parts(coordinates, triangles, links).orient();
}
} // namespace palpate
