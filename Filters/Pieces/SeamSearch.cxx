// SPDX-License-Identifier: BSD-3-Clause
#include "Pieces/SeamSearch.h"

#include "Response/BodyConversion.h"
#include "Contact/TriangleLinks.h"
#include "Contact/TriangleProjection.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

namespace palpate
{
namespace
{
// Tolerance for each component of unit normals, because the normals may have been rounded in a
// file.
constexpr double NormalTolerance = 1e-4;

/// A point on the border of a piece, in the form that is sent to the other ranks.
struct BorderPoint
{
  std::array<double, 3> at;
  std::array<float, 3> normal;

  bool isSame(const BorderPoint& other, double tolerance) const
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (!(std::abs(this->at[k] - other.at[k]) <= tolerance) ||
        !(std::abs(static_cast<double>(this->normal[k]) - static_cast<double>(other.normal[k])) <=
          NormalTolerance))
      {
        return false;
      }
    }
    return true;
  }
};

/// An edge of a triangle, in the direction in which the triangle traverses it.
struct Edge
{
  std::int32_t from;
  std::int32_t to;
};

/// The part of a piece that is within the boxes of other pieces. Only this part can have a seam.
class Overlap
{
public:
  Overlap(vtkPolyData* body, const std::vector<Eigen::AlignedBox3d>& others)
  {
    const std::vector<std::int32_t> triangles = copyTriangles(body);
    const auto count = static_cast<std::size_t>(body->GetNumberOfPoints());
    std::vector<char> within(count, 0);
    for (std::size_t i = 0; i < count; ++i)
    {
      Vector3 x;
      body->GetPoint(static_cast<vtkIdType>(i), x.data());
      within[i] = std::any_of(others.begin(), others.end(),
        [&x](const Eigen::AlignedBox3d& box) { return box.contains(x); });
    }
    // All triangles around the points in the boxes are included, so that all edges at these points
    // are known.
    std::vector<std::int32_t> number(count, -1);
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
    {
      const std::int32_t* corner = triangles.data() + i;
      if (std::none_of(corner, corner + 3,
            [&within](std::int32_t p) { return within[static_cast<std::size_t>(p)] != 0; }))
      {
        continue;
      }
      TriangleCorners renumbered{};
      for (std::size_t k = 0; k < 3; ++k)
      {
        std::int32_t& given = number[static_cast<std::size_t>(corner[k])];
        if (given < 0)
        {
          given = static_cast<std::int32_t>(this->Points.size());
          this->Points.push_back(corner[k]);
        }
        renumbered[k] = given;
      }
      this->Triangles.push_back(renumbered);
    }
    const TriangleLinks links(this->Triangles, this->Points.size());
    for (std::size_t t = 0; t < this->Triangles.size(); ++t)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        if (links.neighbours(t)[k] == TriangleLinks::Border)
        {
          this->Edges.push_back(
            { this->point(this->Triangles[t][k]), this->point(this->Triangles[t][(k + 1) % 3]) });
        }
      }
    }
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      const std::int32_t point = this->Points[i];
      if (within[static_cast<std::size_t>(point)] && links.onBorder(static_cast<std::int32_t>(i)))
      {
        this->Border.push_back(point);
      }
    }
    std::sort(this->Border.begin(), this->Border.end());
  }

  /// Returns the points on the border of the piece, in ascending order.
  const std::vector<std::int32_t>& border() const { return this->Border; }
  const std::vector<Edge>& edges() const { return this->Edges; }

private:
  std::int32_t point(std::int32_t number) const
  {
    return this->Points[static_cast<std::size_t>(number)];
  }

  std::vector<std::int32_t> Points;
  std::vector<TriangleCorners> Triangles;
  std::vector<std::int32_t> Border;
  std::vector<Edge> Edges;
};

Eigen::AlignedBox3d boxOf(vtkPolyData* body)
{
  Eigen::AlignedBox3d box;
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    Vector3 x;
    body->GetPoint(i, x.data());
    if (x.allFinite())
    {
      box.extend(x);
    }
  }
  return box;
}

/// Finds points at the same position with a grid whose cells are wider than the tolerance.
class PositionGrid
{
public:
  explicit PositionGrid(double tolerance)
    : Tolerance(tolerance)
    , Size(8.0 * tolerance)
  {
  }
  /// Returns the group of the point. It is the group of an earlier point at the same position or,
  /// if there is none, a new group.
  std::int32_t groupOf(const BorderPoint& point)
  {
    std::array<std::int64_t, 3> low{};
    std::array<std::int64_t, 3> high{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      low[k] = this->cellOf(point.at[k] - this->Tolerance);
      high[k] = this->cellOf(point.at[k] + this->Tolerance);
    }
    for (std::int64_t x = low[0]; x <= high[0]; ++x)
    {
      for (std::int64_t y = low[1]; y <= high[1]; ++y)
      {
        for (std::int64_t z = low[2]; z <= high[2]; ++z)
        {
          const auto found = this->Cells.find(keyOf({ x, y, z }));
          if (found == this->Cells.end())
          {
            continue;
          }
          for (const std::int32_t group : found->second)
          {
            if (this->First[static_cast<std::size_t>(group)].isSame(point, this->Tolerance))
            {
              return group;
            }
          }
        }
      }
    }
    const auto group = static_cast<std::int32_t>(this->First.size());
    this->First.push_back(point);
    this
      ->Cells[keyOf(
        { this->cellOf(point.at[0]), this->cellOf(point.at[1]), this->cellOf(point.at[2]) })]
      .push_back(group);
    return group;
  }
  std::size_t groups() const { return this->First.size(); }

private:
  std::int64_t cellOf(double x) const
  {
    return static_cast<std::int64_t>(std::floor(x / this->Size));
  }
  /// Returns the key of a cell. Several cells may have the same key. Their points are then
  /// distinguished by comparing positions.
  static std::uint64_t keyOf(const std::array<std::int64_t, 3>& cell)
  {
    std::uint64_t key = 0;
    for (const std::int64_t c : cell)
    {
      key = (key ^ static_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15ULL;
      key ^= key >> 29;
    }
    return key;
  }

  double Tolerance;
  double Size;
  std::vector<BorderPoint> First;
  std::unordered_map<std::uint64_t, std::vector<std::int32_t>> Cells;
};

std::vector<BorderPoint> describe(vtkPolyData* body, const std::vector<std::int32_t>& points)
{
  vtkDataArray* normals = body->GetPointData()->GetNormals();
  std::vector<BorderPoint> described;
  described.reserve(points.size());
  for (const std::int32_t point : points)
  {
    BorderPoint next{ {}, { 0.0F, 0.0F, 0.0F } };
    body->GetPoint(point, next.at.data());
    if (normals)
    {
      Vector3 n;
      normals->GetTuple(point, n.data());
      const double length = n.norm();
      for (std::size_t k = 0; k < 3 && length > 0.0 && std::isfinite(length); ++k)
      {
        next.normal[k] = static_cast<float>(n[static_cast<Eigen::Index>(k)] / length);
      }
    }
    described.push_back(next);
  }
  return described;
}

/// Returns the boxes of the other ranks' pieces, enlarged by `tolerance`. `tolerance` receives a
/// value that is the same on all ranks.
std::vector<Eigen::AlignedBox3d> findOthers(
  const Ranks& ranks, vtkPolyData* body, double& tolerance)
{
  const Eigen::AlignedBox3d own = boxOf(body);
  const auto all =
    ranks.gather(own.isEmpty() ? std::vector<double>{}
                               : std::vector<double>{ own.min().x(), own.min().y(), own.min().z(),
                                   own.max().x(), own.max().y(), own.max().z() });
  double farthest = std::numeric_limits<double>::min();
  for (const std::vector<double>& box : all)
  {
    for (const double x : box)
    {
      farthest = std::max(farthest, std::abs(x));
    }
  }
  tolerance = 4.0 * static_cast<double>(std::numeric_limits<float>::epsilon()) * farthest;
  std::vector<Eigen::AlignedBox3d> others;
  for (std::size_t rank = 0; rank < all.size(); ++rank)
  {
    if (static_cast<int>(rank) != ranks.own() && !all[rank].empty())
    {
      const Vector3 low = Eigen::Map<const Vector3>(all[rank].data()).array() - tolerance;
      const Vector3 high = Eigen::Map<const Vector3>(all[rank].data() + 3).array() + tolerance;
      others.emplace_back(low, high);
    }
  }
  return others;
}

/// Returns the group of each border point of each rank.
std::vector<std::vector<std::int32_t>> findGroups(
  const std::vector<std::vector<BorderPoint>>& points, double tolerance)
{
  PositionGrid place(tolerance);
  std::vector<std::vector<std::int32_t>> groups(points.size());
  for (std::size_t rank = 0; rank < points.size(); ++rank)
  {
    for (const BorderPoint& point : points[rank])
    {
      groups[rank].push_back(place.groupOf(point));
    }
  }
  return groups;
}

/// Returns the index of each group as a seam point; -1 if the group is on one rank only.
std::vector<std::int32_t> numberSeams(const std::vector<std::vector<std::int32_t>>& groups)
{
  constexpr int unseen = -1;
  constexpr int several = -2;
  std::vector<int> rankOf;
  for (std::size_t r = 0; r < groups.size(); ++r)
  {
    const auto rank = static_cast<int>(r);
    for (const std::int32_t group : groups[r])
    {
      rankOf.resize(std::max(rankOf.size(), static_cast<std::size_t>(group) + 1), unseen);
      int& of = rankOf[static_cast<std::size_t>(group)];
      of = of == unseen || of == rank ? rank : several;
    }
  }
  std::vector<std::int32_t> seamOf(rankOf.size(), -1);
  std::int32_t next = 0;
  for (std::size_t group = 0; group < rankOf.size(); ++group)
  {
    if (rankOf[group] == several)
    {
      seamOf[group] = next++;
    }
  }
  return seamOf;
}

std::size_t countJoined(const std::vector<std::vector<Edge>>& edges)
{
  std::map<std::array<std::int32_t, 2>, std::array<std::size_t, 2>> uses;
  for (const std::vector<Edge>& ofRank : edges)
  {
    for (const Edge& edge : ofRank)
    {
      const auto ends = std::minmax(edge.from, edge.to);
      ++uses[{ ends.first, ends.second }][edge.from < edge.to ? 0 : 1];
    }
  }
  std::size_t joined = 0;
  for (const auto& use : uses)
  {
    joined += 2 * std::min(use.second[0], use.second[1]);
  }
  return joined;
}
} // namespace

BodySeam::Points findSeam(const Ranks& ranks, vtkPolyData* body)
{
  BodySeam::Points found;
  double tolerance = 0.0;
  const Overlap overlap(body, findOthers(ranks, body, tolerance));
  const std::vector<std::vector<std::int32_t>> groups =
    findGroups(ranks.gather(describe(body, overlap.border())), tolerance);
  const std::vector<std::int32_t> seamOf = numberSeams(groups);
  for (const std::int32_t seam : seamOf)
  {
    found.size += seam >= 0 ? 1 : 0;
  }

  found.seams.resize(groups.size());
  std::vector<std::int32_t> seamOfPoint(static_cast<std::size_t>(body->GetNumberOfPoints()), -1);
  for (std::size_t rank = 0; rank < groups.size(); ++rank)
  {
    for (std::size_t i = 0; i < groups[rank].size(); ++i)
    {
      const std::int32_t seam = seamOf[static_cast<std::size_t>(groups[rank][i])];
      if (seam < 0)
      {
        continue;
      }
      found.seams[rank].push_back(seam);
      if (static_cast<int>(rank) == ranks.own())
      {
        const std::int32_t point = overlap.border()[i];
        found.places.push_back({ point, seam });
        seamOfPoint[static_cast<std::size_t>(point)] = seam;
      }
    }
  }
  std::vector<Edge> edges;
  for (const Edge& edge : overlap.edges())
  {
    const Edge seams{ seamOfPoint[static_cast<std::size_t>(edge.from)],
      seamOfPoint[static_cast<std::size_t>(edge.to)] };
    if (seams.from >= 0 && seams.to >= 0)
    {
      edges.push_back(seams);
    }
  }
  found.joinedEdges = countJoined(ranks.gather(edges));
  return found;
}
} // namespace palpate
