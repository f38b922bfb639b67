// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/EdgeDistance.h"

#include "Contact/TriangleLinks.h"
#include "Mechanics/Numerics/Constants.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>

namespace palpate
{
namespace
{
using Eigen::Vector3d;

constexpr double Opposite = -0.3;       // cosine between two ways of which one goes on the other
constexpr double SpacingsPerCell = 2.0; // at least, of the root of the area a point has
constexpr double LongFacet = 4.0;       // squares of the contact radius: its area
constexpr double SmallPatch = 0.2;      // of a cell: too few facets to know its normal
constexpr double SmallestBorder = 4.0;  // contact radii

/// A cell's facets, or one long facet, as one.
struct Patch
{
  Vector3d normal = Vector3d::Zero(); ///< of its area; unit in the end
  Vector3d centre = Vector3d::Zero();
  double area = 0.0;
  bool isAlone = false; ///< one long facet
  std::vector<int> beside;
};

/// A side of a facet that is an edge.
struct Side
{
  std::int32_t from;
  std::int32_t to;
  float turn;
};

double angleBetween(const Vector3d& one, const Vector3d& other)
{
  return std::atan2(one.cross(other).norm(), one.dot(other));
}

double distanceTo(const Vector3d& point, const Vector3d& from, const Vector3d& to)
{
  const Vector3d along = to - from;
  const double length = along.squaredNorm();
  const double part = length > 0.0 ? std::clamp((point - from).dot(along) / length, 0.0, 1.0) : 0.0;
  return (point - from - part * along).norm();
}

class EdgeFinder
{
public:
  EdgeFinder(const TriangleSpans& surface, double radius, const unsigned char* isSeam)
    : Surface(surface)
    , Radius(radius)
    , IsSeam(isSeam)
    , Corners(cornersOf(surface))
    , Links(this->Corners, surface.pointCount)
  {
    this->findNormals();
    this->findCellSize();
    this->makePatches();
    this->findTurns();
    this->collectSides();
    this->collectBorder();
  }

  const std::vector<Side>& sides() const { return this->Sides; }
  const std::vector<Side>& border() const { return this->Border; }
  const TriangleLinks& links() const { return this->Links; }
  const std::vector<TriangleCorners>& corners() const { return this->Corners; }
  Vector3d point(std::int32_t i) const
  {
    return Eigen::Map<const Vector3d>(this->Surface.points + 3 * static_cast<std::size_t>(i));
  }

private:
  static std::vector<TriangleCorners> cornersOf(const TriangleSpans& surface)
  {
    std::vector<TriangleCorners> corners(surface.triangleCount);
    for (std::size_t t = 0; t < corners.size(); ++t)
    {
      std::copy_n(surface.triangles + 3 * t, 3, corners[t].begin());
      const auto place = [&](std::size_t i)
      {
        return Eigen::Map<const Vector3d>(
          surface.points + 3 * static_cast<std::size_t>(corners[t][i]));
      };
      const Vector3d area = (place(1) - place(0)).cross(place(2) - place(0));
      if (!(area.squaredNorm() > 0.0 && std::isfinite(area.squaredNorm())))
      {
        corners[t].fill(-1); // takes no part
      }
    }
    return corners;
  }

  void findNormals()
  {
    this->Areas.resize(this->Corners.size(), Vector3d::Zero());
    for (std::size_t t = 0; t < this->Corners.size(); ++t)
    {
      const TriangleCorners& c = this->Corners[t];
      if (c[0] >= 0)
      {
        const Vector3d first = this->point(c[0]);
        this->Areas[t] = 0.5 * (this->point(c[1]) - first).cross(this->point(c[2]) - first);
      }
    }
  }

  /// Cells of the contact's size, or of a few facets of a coarse mesh.
  void findCellSize()
  {
    double area = 0.0;
    for (const Vector3d& facet : this->Areas)
    {
      area += facet.norm();
    }
    const double spacing =
      std::sqrt(area / std::max<double>(1.0, static_cast<double>(this->Surface.pointCount)));
    this->Cell = std::max(this->Radius, SpacingsPerCell * spacing);
  }

  /// Facets whose middle lies in one cell, and that do not look opposite ways, are one patch.
  void makePatches()
  {
    struct Key
    {
      std::array<std::int64_t, 3> cell;
      std::int32_t facet;
      bool operator<(const Key& other) const
      {
        return std::tie(this->cell, this->facet) < std::tie(other.cell, other.facet);
      }
    };
    std::vector<Key> keys;
    keys.reserve(this->Corners.size());
    this->PatchOf.assign(this->Corners.size(), -1);
    for (std::size_t t = 0; t < this->Corners.size(); ++t)
    {
      if (this->Corners[t][0] < 0)
      {
        continue;
      }
      if (this->Areas[t].norm() > LongFacet * this->Radius * this->Radius)
      {
        this->Patches.emplace_back();
        this->Patches.back().isAlone = true;
        this->addFacet(t);
        continue;
      }
      const Vector3d middle = this->middleOf(t);
      Key key{ {}, static_cast<std::int32_t>(t) };
      for (std::size_t k = 0; k < 3; ++k)
      {
        key.cell[k] =
          static_cast<std::int64_t>(std::floor(middle[static_cast<Eigen::Index>(k)] / this->Cell));
      }
      keys.push_back(key);
    }
    std::sort(keys.begin(), keys.end());
    std::size_t first = this->Patches.size(); // of the cell
    for (std::size_t i = 0; i < keys.size(); ++i)
    {
      const auto t = static_cast<std::size_t>(keys[i].facet);
      first = i == 0 || keys[i].cell != keys[i - 1].cell ? this->Patches.size() : first;
      std::size_t found = first;
      while (
        found < this->Patches.size() && !(this->Patches[found].normal.dot(this->Areas[t]) > 0.0))
      {
        ++found;
      }
      if (found == this->Patches.size())
      {
        this->Patches.emplace_back();
      }
      std::swap(this->Patches[found], this->Patches.back());
      this->addFacet(t);
      std::swap(this->Patches[found], this->Patches.back());
      this->PatchOf[t] = static_cast<int>(found);
    }
    for (Patch& patch : this->Patches)
    {
      patch.centre /= patch.area;
      patch.normal.normalize();
    }
    for (std::size_t t = 0; t < this->Corners.size(); ++t)
    {
      for (const std::int32_t other : this->Links.neighbours(t))
      {
        if (this->PatchOf[t] >= 0 && other >= 0 &&
          this->PatchOf[t] != this->PatchOf[static_cast<std::size_t>(other)])
        {
          this->Patches[static_cast<std::size_t>(this->PatchOf[t])].beside.push_back(
            this->PatchOf[static_cast<std::size_t>(other)]);
        }
      }
    }
    for (Patch& patch : this->Patches)
    {
      std::sort(patch.beside.begin(), patch.beside.end());
      patch.beside.erase(std::unique(patch.beside.begin(), patch.beside.end()), patch.beside.end());
    }
  }

  Vector3d middleOf(std::size_t t) const
  {
    const TriangleCorners& c = this->Corners[t];
    return (this->point(c[0]) + this->point(c[1]) + this->point(c[2])) / 3.0;
  }

  /// To the last patch.
  void addFacet(std::size_t t)
  {
    Patch& patch = this->Patches.back();
    const double area = this->Areas[t].norm();
    patch.normal += this->Areas[t];
    patch.centre += area * this->middleOf(t);
    patch.area += area;
    this->PatchOf[t] = static_cast<int>(this->Patches.size()) - 1;
  }

  /// By how much the surface turns away from one patch to another; negative where it is hollow.
  double turn(int one, int other) const
  {
    const Patch& a = this->Patches[static_cast<std::size_t>(one)];
    const Patch& b = this->Patches[static_cast<std::size_t>(other)];
    const double angle = angleBetween(a.normal, b.normal);
    return (b.normal - a.normal).dot(b.centre - a.centre) < 0.0 ? -angle : angle;
  }
  double length(int one, int other) const
  {
    return std::max(0.5 * this->Radius,
      (this->Patches[static_cast<std::size_t>(one)].centre -
        this->Patches[static_cast<std::size_t>(other)].centre)
        .norm());
  }

  bool isKnown(int patch) const
  {
    const Patch& here = this->Patches[static_cast<std::size_t>(patch)];
    return here.isAlone || here.area > SmallPatch * this->Cell * this->Cell;
  }

  /// The rate, rad/mm, at which it turns on beyond `patch`, seen from `from`: the mean of the ways
  /// that go on; from a long facet the least, since another edge may end it.
  double rateBeyond(int from, int patch) const
  {
    const Patch& here = this->Patches[static_cast<std::size_t>(patch)];
    const Vector3d back = this->Patches[static_cast<std::size_t>(from)].centre - here.centre;
    double least = Infinity;
    double sum = 0.0;
    double weights = 0.0;
    for (const int next : here.beside)
    {
      const Patch& beyond = this->Patches[static_cast<std::size_t>(next)];
      const Vector3d on = beyond.centre - here.centre;
      if (next != from && this->isKnown(next) && on.dot(back) < Opposite * on.norm() * back.norm())
      {
        const double rate = this->turn(patch, next) / this->length(patch, next);
        least = std::min(least, rate);
        sum += beyond.area * rate;
        weights += beyond.area;
      }
    }
    return weights > 0.0 ? std::max(0.0, here.isAlone ? least : sum / weights) : 0.0;
  }

  /// What the surface turns between two patches more than at the rate beside them.
  double excess(int before, int after, int beforeFrom, int afterFrom) const
  {
    const double angle = this->turn(before, after);
    if (!(angle > EdgeDistance::LeastTurn) || !this->isKnown(before) || !this->isKnown(after))
    {
      return 0.0;
    }
    const double rate =
      std::max(this->rateBeyond(beforeFrom, before), this->rateBeyond(afterFrom, after));
    return angle - rate * this->length(before, after);
  }

  void findTurns()
  {
    this->Turns.assign(this->Patches.size(), 0.0F);
    for (std::size_t c = 0; c < this->Patches.size(); ++c)
    {
      const int here = static_cast<int>(c);
      const std::vector<int>& beside = this->Patches[c].beside;
      double most = 0.0;
      for (std::size_t i = 0; i < beside.size(); ++i)
      {
        most = std::max(most, this->excess(here, beside[i], beside[i], here));
        const Vector3d one =
          this->Patches[static_cast<std::size_t>(beside[i])].centre - this->Patches[c].centre;
        for (std::size_t k = i + 1; k < beside.size(); ++k)
        {
          const Vector3d other =
            this->Patches[static_cast<std::size_t>(beside[k])].centre - this->Patches[c].centre;
          if (one.dot(other) < Opposite * one.norm() * other.norm())
          {
            most = std::max(most, this->excess(beside[i], beside[k], here, here));
          }
        }
      }
      this->Turns[c] = most > EdgeDistance::LeastTurn ? static_cast<float>(most) : 0.0F;
    }
  }

  /// By how much the facets turn away along side `i` of a facet.
  double facetTurn(std::size_t t, std::size_t i) const
  {
    const std::int32_t other = this->Links.neighbours(t)[i];
    if (other < 0 || this->Corners[t][0] < 0)
    {
      return 0.0;
    }
    const auto o = static_cast<std::size_t>(other);
    const bool isConvex =
      (this->middleOf(o) - this->point(this->Corners[t][i])).dot(this->Areas[t]) < 0.0;
    return isConvex ? angleBetween(this->Areas[t], this->Areas[o]) : 0.0;
  }

  /// In patches with an edge, the sides that turn at least half as much as the sharpest one.
  void collectSides()
  {
    std::vector<double> sharpest(this->Patches.size(), 0.0);
    const auto forSides = [&](auto&& visit)
    {
      for (std::size_t t = 0; t < this->Corners.size(); ++t)
      {
        const int patch = this->PatchOf[t];
        if (patch < 0 || !(this->Turns[static_cast<std::size_t>(patch)] > 0.0F))
        {
          continue;
        }
        for (std::size_t i = 0; i < 3; ++i)
        {
          visit(t, i, static_cast<std::size_t>(patch), this->facetTurn(t, i));
        }
      }
    };
    forSides([&](std::size_t, std::size_t, std::size_t patch, double turn)
      { sharpest[patch] = std::max(sharpest[patch], turn); });
    forSides(
      [&](std::size_t t, std::size_t i, std::size_t patch, double turn)
      {
        if (turn > 0.0 && turn >= 0.5 * sharpest[patch])
        {
          this->Sides.push_back(
            { this->Corners[t][i], this->Corners[t][(i + 1) % 3], this->Turns[patch] });
        }
      });
  }

  void collectBorder()
  {
    // Sides of one facet, by where they lie: those of doubled points lie there twice.
    using Place = std::array<double, 3>;
    std::map<std::pair<Place, Place>, int> at;
    std::vector<Side> border;
    const auto keyOf = [this](const Side& side)
    {
      Place one;
      Place other;
      std::copy_n(this->point(side.from).data(), 3, one.begin());
      std::copy_n(this->point(side.to).data(), 3, other.begin());
      return one < other ? std::make_pair(one, other) : std::make_pair(other, one);
    };
    for (std::size_t t = 0; t < this->Corners.size(); ++t)
    {
      for (std::size_t i = 0; this->Corners[t][0] >= 0 && i < 3; ++i)
      {
        const Side side{ this->Corners[t][i], this->Corners[t][(i + 1) % 3], 0.0F };
        const bool isSeam = this->IsSeam && this->IsSeam[side.from] && this->IsSeam[side.to];
        if (this->Links.neighbours(t)[i] == TriangleLinks::Border && !isSeam)
        {
          border.push_back(side);
          ++at[keyOf(side)];
        }
      }
    }
    border.erase(std::remove_if(border.begin(), border.end(),
                   [&](const Side& side) { return at[keyOf(side)] > 1; }),
      border.end());
    this->dropHoles(border);
    this->Border = std::move(border);
  }

  /// Loops shorter than a contact are holes of a scan.
  void dropHoles(std::vector<Side>& border) const
  {
    std::map<std::int32_t, std::int32_t> above;
    const auto rootOf = [&above](std::int32_t i)
    {
      above.emplace(i, i);
      while (above[i] != i)
      {
        i = above[i] = above[above[i]];
      }
      return i;
    };
    for (const Side& side : border)
    {
      above[rootOf(side.from)] = rootOf(side.to);
    }
    std::map<std::int32_t, double> lengths;
    for (const Side& side : border)
    {
      lengths[rootOf(side.from)] += (this->point(side.to) - this->point(side.from)).norm();
    }
    border.erase(std::remove_if(border.begin(), border.end(),
                   [&](const Side& side)
                   { return lengths[rootOf(side.from)] < Pi * SmallestBorder * this->Radius; }),
      border.end());
  }

  const TriangleSpans& Surface;
  double Radius;
  double Cell = 0.0; ///< mm
  const unsigned char* IsSeam;
  std::vector<TriangleCorners> Corners;
  TriangleLinks Links;
  std::vector<Vector3d> Areas;
  std::vector<int> PatchOf;
  std::vector<Patch> Patches;
  std::vector<float> Turns; ///< of the patches
  std::vector<Side> Sides;
  std::vector<Side> Border;
};
} // namespace

EdgeDistance::EdgeDistance(
  const TriangleSpans& surface, double contactRadius, double reach, const unsigned char* isSeam)
  : Found(surface.pointCount)
{
  const EdgeFinder finder(surface, contactRadius, isSeam);
  this->EdgeCount = finder.sides().size();

  // From the sides outwards; a point hands on the side it is nearest to.
  using Entry = std::pair<float, std::pair<std::int32_t, std::int32_t>>; // distance, point, side
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  const auto spread = [&](const std::vector<Side>& sides, float NearEdge::*distance)
  {
    const auto offer = [&](std::int32_t point, std::int32_t side)
    {
      const Side& edge = sides[static_cast<std::size_t>(side)];
      const auto away = static_cast<float>(
        distanceTo(finder.point(point), finder.point(edge.from), finder.point(edge.to)));
      NearEdge& found = this->Found[static_cast<std::size_t>(point)];
      if (away < found.*distance && static_cast<double>(away) <= reach)
      {
        found.*distance = away;
        found.turn = edge.turn > 0.0F ? edge.turn : found.turn;
        front.push({ away, { point, side } });
      }
    };
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      offer(sides[i].from, static_cast<std::int32_t>(i));
      offer(sides[i].to, static_cast<std::int32_t>(i));
    }
    while (!front.empty())
    {
      const auto [away, from] = front.top();
      front.pop();
      if (away > this->Found[static_cast<std::size_t>(from.first)].*distance)
      {
        continue;
      }
      const auto around = finder.links().around(from.first);
      for (const std::int32_t* t = around[0]; t != around[1]; ++t)
      {
        for (const std::int32_t corner : finder.corners()[static_cast<std::size_t>(*t)])
        {
          offer(corner, from.second);
        }
      }
    }
  };
  spread(finder.sides(), &NearEdge::distance);
  spread(finder.border(), &NearEdge::border);
}

double edgeFactor(double poissonsRatio, double distanceOverRadius)
{
  // ψ of a point load, C = ψ/(2πE* d); and what keeps the force at the edge itself.
  constexpr std::array<double, 6> ratio = { 0.0, 0.15, 0.25, 0.3, 0.45, 0.5 };
  constexpr std::array<double, 6> value = { 1.3653, 1.5166, 1.7107, 1.8448, 2.4487, 2.7481 };
  const double nu = std::clamp(poissonsRatio, 0.0, 0.5);
  std::size_t i = 1;
  while (i + 1 < ratio.size() && nu > ratio[i])
  {
    ++i;
  }
  const double psi =
    value[i - 1] + (value[i] - value[i - 1]) * (nu - ratio[i - 1]) / (ratio[i] - ratio[i - 1]);
  constexpr double atEdge = 0.42;
  const double x = distanceOverRadius + atEdge * std::exp(-distanceOverRadius);
  return x / (x + psi / Pi);
}
} // namespace palpate
