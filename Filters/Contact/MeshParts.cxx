// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/MeshParts.h"

#include "Contact/OpenLoops.h"
#include "Contact/PartOverlap.h"
#include "Contact/TriangleColumns.h"
#include "Contact/TwinParts.h"
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
constexpr double LargestCaps = 0.25; ///< largest (area of caps)/(area of the part) of a solid
constexpr double LargestGap = 0.01;  ///< largest (area of caps)/(area of the part) of a closed part
constexpr double LargestScrap = 0.1; ///< largest (area)/(total area) of a part that may be left out
/// Largest (volume)/(volume of the solid around it) of debris.
constexpr double LargestDebris = 1e-6;
/// Least (volume)/area^1.5 of a solid; a sheet of 1 µm by 1 m has a larger value.
constexpr double LeastVolume = 1e-9;

struct Part
{
  std::size_t first; ///< position of its first triangle in Parts::Order
  std::size_t count;
  double area = 0.0;   ///< mm²
  double volume = 0.0; ///< mm³, with the holes closed by caps
  double caps = 0.0;   ///< mm², area of the caps
  Eigen::AlignedBox3d box = {};

  bool isSolid() const { return this->caps <= LargestCaps * this->area; }
  bool isClosed() const { return this->caps <= LargestGap * this->area; }
  bool isEmpty() const
  {
    return this->isSolid() &&
      std::abs(this->volume) <= LeastVolume * this->area * std::sqrt(this->area);
  }
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
    const std::vector<std::int32_t> walls = this->findWalls();
    std::vector<std::vector<std::size_t>> around(this->All.size());
    this->findContainers(around, result.fault);
    if (result.fault.empty() && !walls.empty())
    {
      for (const std::int32_t t : walls)
      {
        this->Triangles[static_cast<std::size_t>(t)][0] = -1;
      }
      result.hasJoined = true;
      return result;
    }
    for (std::size_t i = 0; i < this->All.size() && result.fault.empty(); ++i)
    {
      this->orientPart(i, around[i], result);
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
  /// Checks and orients part i. `around` are the solids that contain the part.
  void orientPart(std::size_t i, const std::vector<std::size_t>& around, OrientedParts& result)
  {
    const Part& part = this->All[i];
    const bool isInside = around.size() % 2 == 1;
    if (part.isSolid() ? isInside && this->isDebris(part, this->All[around.front()])
                       : std::any_of(around.begin(), around.end(),
                           [this](std::size_t o) { return this->All[o].isClosed(); }))
    {
      const auto first = this->Order.begin() + static_cast<std::ptrdiff_t>(part.first);
      const auto last = first + static_cast<std::ptrdiff_t>(part.count);
      result.hidden.insert(result.hidden.end(), first, last);
      this->leaveOut(part);
    }
    else if (part.isSolid() && this->isKept(part) && isInside && part.volume > 0.0)
    {
      result.fault = this->name(i) + " lies inside " + this->name(around.front()) +
        " and winds outward, as a second body in the same place: remove it, or reverse its "
        "triangles if it is a cavity";
    }
    else if (part.isSolid() && this->isKept(part) && !isInside && part.volume < 0.0)
    {
      this->forTriangles(part, [](TriangleCorners& corners) { std::swap(corners[1], corners[2]); });
    }
  }

  /// Returns whether a kept solid that is wound outward is too small to be a separate body inside
  /// the solid around it.
  bool isDebris(const Part& part, const Part& around) const
  {
    return this->isKept(part) && part.volume > 0.0 &&
      part.volume <= LargestDebris * std::abs(around.volume);
  }

  /// Returns whether the part has triangles and is not a copy of another part.
  bool isKept(const Part& part) const
  {
    const auto seed = static_cast<std::size_t>(this->Order[part.first]);
    return !part.isEmpty() && this->Triangles[seed][0] >= 0;
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
    this->forTriangles(part,
      [&](const TriangleCorners& corners)
      {
        const auto [a, b, c] = this->placesOf(corners);
        part.area += 0.5 * (b - a).cross(c - a).norm();
        part.volume += volumeOf(a, b, c);
        part.box.extend(a).extend(b).extend(c);
      });
    this->forCaps(part,
      [&](const Vector3& a, const Vector3& b, const Vector3& c)
      {
        part.volume += volumeOf(a, b, c);
        part.caps += 0.5 * (b - a).cross(c - a).norm();
      });
  }

  /// Calls visit() for the corners of the triangles that close the holes of a part.
  template <class Visit>
  void forCaps(const Part& part, const Visit& visit) const
  {
    OpenLoops loops;
    for (std::size_t i = part.first; i < part.first + part.count; ++i)
    {
      const auto t = static_cast<std::size_t>(this->Order[i]);
      const TriangleCorners& corners = this->Triangles[t];
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
      { visit(this->place(to), this->place(from), centre); });
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
      this->leaveOut(part);
    }
  }

  void leaveOut(const Part& part)
  {
    this->forTriangles(part, [](TriangleCorners& corners) { corners[0] = -1; });
  }

  /// Leaves out copies of parts. Returns the triangles of the walls that two solids share.
  std::vector<std::int32_t> findWalls()
  {
    if (this->All.size() < 2)
    {
      return {};
    }
    std::vector<MeshPart> parts;
    for (const Part& part : this->All)
    {
      parts.push_back({ part.first, part.count, part.isSolid() });
    }
    std::vector<std::int32_t> walls =
      dropCopiedParts(this->Coordinates, this->Triangles, this->Order, parts);
    if (!walls.empty())
    {
      this->IsWall.assign(this->Triangles.size(), false);
      for (const std::int32_t t : walls)
      {
        this->IsWall[static_cast<std::size_t>(t)] = true;
      }
    }
    return walls;
  }

  /// Finds the solids that contain each part. Sets `fault` if two solids overlap.
  void findContainers(std::vector<std::vector<std::size_t>>& around, std::string& fault) const
  {
    this->forMeetingBoxes(
      [&](std::size_t one, std::size_t other)
      {
        const bool isOneLarger = this->All[one].box.volume() >= this->All[other].box.volume();
        const std::size_t outer = isOneLarger ? one : other;
        const std::size_t inner = isOneLarger ? other : one;
        const Part& part = this->All[inner];
        if (!this->All[outer].isSolid() || !fault.empty())
        {
          return;
        }
        const PartOverlap overlap = this->overlapOf(inner, outer);
        // A part may extend through the hole of an open solid.
        const bool isCertain = part.isClosed() && this->All[outer].isClosed();
        if (overlap.inside > (isCertain || !part.isSolid() ? 1.0 - PartOverlap::Least : 0.5))
        {
          around[inner].push_back(outer);
        }
        else if (isCertain && (overlap.isPresent() || this->overlapOf(outer, inner).isPresent()))
        {
          fault = this->name(inner) + " and " + this->name(outer) +
            " overlap or touch: unite them into one surface, or keep one of them";
        }
      });
  }

  /// Calls visit(one, other) once for each pair of parts whose boxes intersect. The sweep is along
  /// the axis on which the extent of the parts is largest.
  template <class Visit>
  void forMeetingBoxes(const Visit& visit) const
  {
    std::vector<std::size_t> parts;
    Vector3 sum = Vector3::Zero();
    Vector3 squares = Vector3::Zero();
    for (std::size_t i = 0; i < this->All.size(); ++i)
    {
      if (this->isKept(this->All[i]))
      {
        parts.push_back(i);
        const Vector3 centre = this->All[i].box.center();
        sum += centre;
        squares += centre.cwiseAbs2();
      }
    }
    Eigen::Index axis = 0;
    (static_cast<double>(parts.size()) * squares - sum.cwiseAbs2()).maxCoeff(&axis);
    std::stable_sort(parts.begin(), parts.end(),
      [&](std::size_t a, std::size_t b)
      { return this->All[a].box.min()[axis] < this->All[b].box.min()[axis]; });
    std::vector<std::size_t> open; // parts whose boxes overlap the current one along the axis
    for (const std::size_t i : parts)
    {
      const Eigen::AlignedBox3d& box = this->All[i].box;
      open.erase(std::remove_if(open.begin(), open.end(),
                   [&](std::size_t o) { return this->All[o].box.max()[axis] < box.min()[axis]; }),
        open.end());
      for (const std::size_t o : open)
      {
        if (this->All[o].box.intersects(box))
        {
          visit(o, i);
        }
      }
      open.push_back(i);
    }
  }

  const TriangleColumns& columnsOf(std::size_t part) const
  {
    const auto found = this->Columns.find(part);
    if (found != this->Columns.end())
    {
      return found->second;
    }
    std::vector<TriangleColumns::Corners> all;
    this->forTriangles(this->All[part],
      [&](const TriangleCorners& corners) { all.push_back(this->placesOf(corners)); });
    this->forCaps(this->All[part],
      [&](const Vector3& a, const Vector3& b, const Vector3& c) {
        all.push_back({ a, b, c });
      });
    return this->Columns.emplace(part, TriangleColumns(std::move(all))).first->second;
  }

  PartOverlap overlapOf(std::size_t inner, std::size_t solid) const
  {
    const Part& part = this->All[inner];
    const std::size_t step = std::max<std::size_t>(1, part.count / PartOverlap::Places);
    std::vector<TriangleColumns::Corners> tried;
    for (std::size_t i = part.first; i < part.first + part.count; i += step)
    {
      const auto t = static_cast<std::size_t>(this->Order[i]);
      if (this->IsWall.empty() || !this->IsWall[t])
      {
        tried.push_back(this->placesOf(this->Triangles[t]));
      }
    }
    return { tried, part.box.sizes().norm(), this->columnsOf(solid), this->All[solid].box };
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
  std::vector<bool> IsWall; ///< one value for each triangle; empty if no triangle is a wall
  mutable std::unordered_map<std::size_t, TriangleColumns> Columns;
};
} // namespace

OrientedParts orientParts(
  const float* coordinates, std::vector<TriangleCorners>& triangles, const TriangleLinks& links)
{
  return Parts(coordinates, triangles, links).orient();
}
} // namespace palpate
