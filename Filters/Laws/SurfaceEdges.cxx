// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/EdgeSurface.h"

#include "Laws/FacePatches.h"
#include "Contact/PackedMesh.h"
#include "Mechanics/Numerics/Constants.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
using Eigen::Vector3d;

// Largest cosine between two directions that count as opposite, so that one continues the other.
constexpr double OppositeCosine = -0.3;
constexpr double SpacingsPerCell = 2.0; // smallest cell, in square roots of the area per point
constexpr double LongFacet = 4.0;       // smallest area of a long facet, in squared contact radii
// A side of a sharp edge has at least this fraction of the angle by which the surface turns within
// two patches. Otherwise the edge is a fillet or a bevel.
constexpr double SharpFraction = 0.8;
// Fraction of the angle up to a patch. If the total angle up to the next patch is below this
// fraction, the next patch is on the face behind the edge.
constexpr double LeastRemainingTurn = 0.5;
// Multiple of the smallest angle beyond a patch. A larger angle belongs to another edge.
constexpr double OtherEdgeRatio = 2.0;

class EdgeFinder
{
public:
  EdgeFinder(const EdgeSurface& surface, double radius)
    : Surface(surface)
    , Radius(radius)
    , Cell(edgeCell(surface, radius))
    , Patches(surface, this->Cell, LongFacet * radius * radius)
  {
    this->findTurns();
    this->collectSides();
  }

  SurfaceEdges take() { return { std::move(this->Sides), this->Cell }; }

private:
  /// Returns the angle (rad) by which the surface turns away from one patch to another; negative in
  /// a hollow.
  double turn(int one, int other) const
  {
    const FacePatch& a = this->Patches.at(one);
    const FacePatch& b = this->Patches.at(other);
    const double angle = angleBetween(a.normal, b.normal);
    return (b.normal - a.normal).dot(b.centre - a.centre) < 0.0 ? -angle : angle;
  }
  double length(int one, int other) const
  {
    return std::max(
      0.5 * this->Radius, (this->Patches.at(one).centre - this->Patches.at(other).centre).norm());
  }

  /// Returns whether one direction continues the other, after projection along the normal. The
  /// projection makes this valid also across a sharp edge.
  static bool areOpposite(const Vector3d& normal, const Vector3d& one, const Vector3d& other)
  {
    const Vector3d flat = one - one.dot(normal) * normal;
    const Vector3d beyond = other - other.dot(normal) * normal;
    return flat.dot(beyond) < OppositeCosine * flat.norm() * beyond.norm();
  }

  /// Returns the rate, rad/mm, at which the surface turns beyond `patch`, in the direction from
  /// `from`. It is the mean over the next patches in that direction. Beyond a long facet it is the
  /// smallest rate, because another edge may bound that facet. The face behind `from` is ignored.
  /// At a corner, a face beyond another sharp edge is ignored too. If none of the next patches is
  /// large enough, the rate is infinite (unknown), and no angle exceeds it.
  double rateBeyond(int from, int patch) const
  {
    const FacePatch& here = this->Patches.at(patch);
    const FacePatch& behind = this->Patches.at(from);
    const Vector3d back = behind.centre - here.centre;
    const double turned = angleBetween(behind.normal, here.normal);
    std::vector<NextPatch> known; // next patches in that direction whose normal is known
    double leastTurn = Infinity;
    bool goesOn = false;
    for (const NextPatch& next : here.next)
    {
      const FacePatch& beyond = this->Patches.at(next.patch);
      if (next.patch == from || !areOpposite(here.normal, beyond.centre - here.centre, back) ||
        angleBetween(behind.normal, beyond.normal) < LeastRemainingTurn * turned)
      {
        continue;
      }
      goesOn = true;
      if (beyond.isKnown)
      {
        known.push_back(next);
        leastTurn = std::min(leastTurn, this->turn(patch, next.patch));
      }
    }
    double least = Infinity;
    double sum = 0.0;
    double weights = 0.0;
    for (const NextPatch& next : known)
    {
      const double turn = this->turn(patch, next.patch);
      if (next.isSharp && turn > OtherEdgeRatio * leastTurn)
      {
        continue;
      }
      const double rate = turn / this->length(patch, next.patch);
      least = std::min(least, rate);
      sum += this->Patches.at(next.patch).area * rate;
      weights += this->Patches.at(next.patch).area;
    }
    if (weights > 0.0)
    {
      return std::max(0.0, here.isLong ? least : sum / weights);
    }
    return goesOn ? Infinity : 0.0;
  }

  /// Returns the angle (rad) by which the surface turns between two patches, minus the angle that
  /// corresponds to the larger of the rates on both sides.
  double excess(int before, int after, int beforeFrom, int afterFrom) const
  {
    const double angle = this->turn(before, after);
    if (!(angle > SurfaceEdges::LeastTurn) || !this->Patches.at(before).isKnown ||
      !this->Patches.at(after).isKnown)
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
      const FacePatch& patch = this->Patches.at(here);
      double most = 0.0;
      for (std::size_t i = 0; i < patch.next.size(); ++i)
      {
        const int before = patch.next[i].patch;
        most = std::max(most, this->excess(here, before, before, here));
        for (std::size_t k = i + 1; k < patch.next.size(); ++k)
        {
          const int after = patch.next[k].patch;
          if (areOpposite(patch.normal, this->Patches.at(before).centre - patch.centre,
                this->Patches.at(after).centre - patch.centre))
          {
            most = std::max(most, this->excess(before, after, here, here));
          }
        }
      }
      this->Turns[c] = most > SurfaceEdges::LeastTurn ? static_cast<float>(most) : 0.0F;
    }
  }

  /// Collects the facet sides of patches with an edge. The angle at a side must be at least half of
  /// that at the sharpest side of its patch.
  void collectSides()
  {
    std::vector<double> sharpest(this->Patches.size(), 0.0);
    const auto forSides = [&](auto&& visit)
    {
      for (std::size_t t = 0; t < this->Surface.corners.size(); ++t)
      {
        const int patch = this->Patches.of(t);
        if (patch < 0 || !(this->Turns[static_cast<std::size_t>(patch)] > 0.0F))
        {
          continue;
        }
        for (std::size_t i = 0; i < 3; ++i)
        {
          visit(t, i, static_cast<std::size_t>(patch), facetTurn(this->Surface, t, i));
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
          const bool isSharp = turn >= PackedMesh::BluntTurn && turn >= SharpFraction * whole;
          const TriangleCorners& corners = this->Surface.corners[t];
          this->Sides.push_back({ corners[i], corners[(i + 1) % 3], this->Turns[patch], isSharp });
        }
      });
  }

  const EdgeSurface& Surface;
  double Radius;
  double Cell; ///< mm
  FacePatches Patches;
  std::vector<float> Turns; ///< angle of the edge at each patch, rad; 0 if there is no edge
  std::vector<SurfaceSide> Sides;
};
} // namespace

double edgeCell(const EdgeSurface& surface, double contactRadius)
{
  return std::max(contactRadius, SpacingsPerCell * surface.spacing);
}

SurfaceEdges findEdges(const EdgeSurface& surface, double contactRadius)
{
  return EdgeFinder(surface, contactRadius).take();
}
} // namespace palpate
