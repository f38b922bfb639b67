// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/LinkedSurface.h"

#include "Contact/PackedMesh.h"
#include "Mechanics/Numerics/Constants.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace palpate
{
namespace
{
using Eigen::Vector3d;

constexpr double Opposite = -0.3; // cosine between two directions of which one continues the other
constexpr double SameWay = 0.15;  // cosine between a patch and its facets, at least
constexpr double SpacingsPerCell = 2.0; // at least, in square roots of the area per point
constexpr double LongFacet = 4.0;       // area in squared contact radii
constexpr double MostOfTheTurn = 0.8;   // otherwise it is a fillet or a bevel
constexpr double SmallPatch = 0.2;      // of a cell: too few facets to know its normal

/// The facets of a cell, or one long facet.
struct Patch
{
  Vector3d normal = Vector3d::Zero(); ///< weighted by area; unit in the end
  Vector3d centre = Vector3d::Zero();
  double area = 0.0;
  bool isAlone = false; ///< one long facet
  std::vector<int> beside;
};

double angleBetween(const Vector3d& one, const Vector3d& other)
{
  return std::atan2(one.cross(other).norm(), one.dot(other));
}

class EdgeFinder
{
public:
  EdgeFinder(const LinkedSurface& surface, double radius)
    : Surface(surface)
    , Radius(radius)
    , Corners(surface.corners)
    , Areas(surface.areas)
  {
    this->findCellSize();
    this->makePatches();
    this->findTurns();
    this->collectSides();
  }

  SurfaceEdges take() { return { std::move(this->Sides), this->Cell }; }

private:
  /// Cells of the contact's size, or of a few facets of a coarse mesh.
  void findCellSize()
  {
    double area = 0.0;
    for (const Vector3d& facet : this->Areas)
    {
      area += facet.norm();
    }
    const auto points = static_cast<double>(this->Surface.usedPoints());
    const double spacing = std::sqrt(area / std::max(1.0, points));
    this->Cell = std::max(this->Radius, SpacingsPerCell * spacing);
  }

  /// Facets whose centres lie in one cell, and whose normals are alike, form one patch.
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
      const Vector3d place = this->middleOf(t) / this->Cell;
      Key key{ {}, static_cast<std::int32_t>(t) };
      for (std::size_t k = 0; k < 3; ++k)
      {
        key.cell[k] = static_cast<std::int64_t>(std::floor(place[static_cast<Eigen::Index>(k)]));
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
      while (found < this->Patches.size() &&
        !this->facesAlike(this->Patches[found].normal, this->Areas[t]))
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
      for (const std::int32_t other : this->Surface.links.neighbours(t))
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

  /// Faces at a right angle are never averaged.
  static bool facesAlike(const Vector3d& one, const Vector3d& other)
  {
    return one.dot(other) > SameWay * one.norm() * other.norm();
  }

  Vector3d middleOf(std::size_t t) const
  {
    const TriangleCorners& c = this->Corners[t];
    return (this->Surface.place(c[0]) + this->Surface.place(c[1]) + this->Surface.place(c[2])) /
      3.0;
  }

  /// Adds a facet to the last patch.
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

  /// Whether one direction continues the other, seen along the mean normal, also over a sharp edge.
  static bool areOpposite(const Vector3d& normal, const Vector3d& one, const Vector3d& other)
  {
    const Vector3d flat = one - one.dot(normal) * normal;
    const Vector3d beyond = other - other.dot(normal) * normal;
    return flat.dot(beyond) < Opposite * flat.norm() * beyond.norm();
  }

  bool isKnown(int patch) const
  {
    const Patch& here = this->Patches[static_cast<std::size_t>(patch)];
    return here.isAlone || here.area > SmallPatch * this->Cell * this->Cell;
  }

  /// The rate, rad/mm, at which the surface turns beyond `patch`, seen from `from`: the mean of the
  /// directions that continue; beyond a long facet the least, since another edge may end it. Where
  /// none of the next patches is large enough, it is not known, and nothing is in excess of it.
  double rateBeyond(int from, int patch) const
  {
    const Patch& here = this->Patches[static_cast<std::size_t>(patch)];
    const Vector3d back = this->Patches[static_cast<std::size_t>(from)].centre - here.centre;
    double least = Infinity;
    double sum = 0.0;
    double weights = 0.0;
    bool goesOn = false;
    for (const int next : here.beside)
    {
      const Patch& beyond = this->Patches[static_cast<std::size_t>(next)];
      if (next == from || !areOpposite(here.normal, beyond.centre - here.centre, back))
      {
        continue;
      }
      goesOn = true;
      if (this->isKnown(next))
      {
        const double rate = this->turn(patch, next) / this->length(patch, next);
        least = std::min(least, rate);
        sum += beyond.area * rate;
        weights += beyond.area;
      }
    }
    if (weights > 0.0)
    {
      return std::max(0.0, here.isAlone ? least : sum / weights);
    }
    return goesOn ? Infinity : 0.0;
  }

  /// The turn of the surface between two patches in excess of the rate beside them.
  double excess(int before, int after, int beforeFrom, int afterFrom) const
  {
    const double angle = this->turn(before, after);
    if (!(angle > SurfaceEdges::LeastTurn) || !this->isKnown(before) || !this->isKnown(after))
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
          if (areOpposite(this->Patches[c].normal, one, other))
          {
            most = std::max(most, this->excess(beside[i], beside[k], here, here));
          }
        }
      }
      this->Turns[c] = most > SurfaceEdges::LeastTurn ? static_cast<float>(most) : 0.0F;
    }
  }

  /// By how much the facets turn away along side `i` of a facet.
  double facetTurn(std::size_t t, std::size_t i) const
  {
    const std::int32_t other = this->Surface.links.neighbours(t)[i];
    if (other < 0 || this->Corners[t][0] < 0)
    {
      return 0.0;
    }
    const auto o = static_cast<std::size_t>(other);
    const bool isConvex =
      (this->middleOf(o) - this->Surface.place(this->Corners[t][i])).dot(this->Areas[t]) < 0.0;
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
          const double whole{ this->Turns[patch] };
          const bool isSharp = turn >= PackedMesh::BluntTurn && turn >= MostOfTheTurn * whole;
          this->Sides.push_back(
            { this->Corners[t][i], this->Corners[t][(i + 1) % 3], this->Turns[patch], isSharp });
        }
      });
  }

  const LinkedSurface& Surface;
  double Radius;
  double Cell = 0.0; ///< mm
  const std::vector<TriangleCorners>& Corners;
  const std::vector<Vector3d>& Areas;
  std::vector<int> PatchOf;
  std::vector<Patch> Patches;
  std::vector<float> Turns; ///< of the patches
  std::vector<SurfaceSide> Sides;
};
} // namespace

SurfaceEdges findEdges(const LinkedSurface& surface, double contactRadius)
{
  return EdgeFinder(surface, contactRadius).take();
}
} // namespace palpate
