// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/SurfaceDisc.h"

#include "Solids/FiniteElements/PatchLoad.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Numerics/SegmentDistance.h"
#include "Solids/TrueShape/SmoothSurface.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace palpate
{
namespace
{
/// Returns whether a point cannot move along its normal.
bool isHeldAlongNormal(const ElasticBody& body, std::int32_t point)
{
  const Eigen::Vector3d& normal = body.surface().normal(point);
  const std::int32_t node = body.surface().node(point);
  bool held = false;
  for (int axis = 0; axis < 3; ++axis)
  {
    held = held || (body.unknown(node, axis) < 0 && std::abs(normal[axis]) > 1e-6);
  }
  return held;
}

constexpr double AlikeModulus = 0.05; ///< largest relative difference of E
constexpr double AlikeRatio = 0.01;

/// Returns whether all elements at a point have nearly the given material.
bool isWithin(const ElasticBody& body, std::int32_t point, const ElasticMaterial& material)
{
  const MeshTopology& topology = body.topology();
  const std::int32_t node = body.surface().node(point);
  return std::all_of(topology.elementsBegin(node), topology.elementsEnd(node),
    [&](std::int32_t element) { return isNearlyAlike(body.material(element), material); });
}

/// Visits the surface around a point.
class DiscWalk
{
public:
  DiscWalk(const ElasticBody& body, std::int32_t point, double radius)
    : Body(body)
    , Surface(body.surface())
    , Centre(point)
    , Radius(radius)
    , Frame(tangentFrame(Surface.normal(point)))
    , Origin(smoothPosition(body, point))
    , Material(body.materialAt(Surface.node(point)))
  {
  }

  void run(SurfaceDisc& disc)
  {
    std::vector<std::int32_t> front = { this->Centre };
    std::unordered_set<std::int32_t> seen = { this->Centre };
    std::unordered_set<std::int32_t> triangles;
    while (!front.empty())
    {
      const std::int32_t from = front.back();
      front.pop_back();
      this->take(from, disc);
      for (const std::int32_t* t = this->Surface.trianglesBegin(from);
           t != this->Surface.trianglesEnd(from); ++t)
      {
        if (!triangles.insert(*t).second)
        {
          continue;
        }
        const double away = this->distance(*t);
        if (away > this->Radius)
        {
          continue;
        }
        // A held triangle begins at its edge, which may be nearer to the point than the triangle's
        // corners.
        if (this->isHeld(*t))
        {
          limit(disc, away, PatchStatus::OutOfReach);
          continue;
        }
        if (this->Surface.triangleNormal(*t).dot(this->Surface.normal(this->Centre)) < ContactTurn)
        {
          limit(disc, away, PatchStatus::Edge);
          continue;
        }
        for (const std::int32_t next : this->Surface.triangle(*t))
        {
          if (seen.insert(next).second)
          {
            front.push_back(next);
          }
        }
      }
    }
    std::sort(disc.points.begin(), disc.points.end(),
      [](const DiscPoint& a, const DiscPoint& b)
      { return a.distance != b.distance ? a.distance < b.distance : a.point < b.point; });
  }

private:
  static void limit(SurfaceDisc& disc, double away, PatchStatus by)
  {
    if (away < disc.limit)
    {
      disc.limit = away;
      disc.limitedBy = by;
    }
  }

  bool isHeld(std::int32_t triangle) const
  {
    const auto& corners = this->Surface.triangle(triangle);
    return std::all_of(corners.begin(), corners.end(),
      [this](std::int32_t point) { return this->Body.isHeld(this->Surface.node(point)); });
  }

  Eigen::Vector3d inFrame(std::int32_t point) const
  {
    return this->Frame.transpose() *
      (this->Surface.position(point) - this->Surface.position(this->Centre));
  }

  double distance(std::int32_t triangle) const
  {
    std::array<Eigen::Vector2d, 3> corner;
    for (std::size_t i = 0; i < 3; ++i)
    {
      corner[i] = this->inFrame(this->Surface.triangle(triangle)[i]).head<2>();
    }
    return std::sqrt(std::min({ squareToSegment(corner[0], corner[1]),
      squareToSegment(corner[1], corner[2]), squareToSegment(corner[2], corner[0]) }));
  }

  void take(std::int32_t point, SurfaceDisc& disc)
  {
    const Eigen::Vector3d at =
      this->Frame.transpose() * (smoothPosition(this->Body, point) - this->Origin);
    const double away = at.head<2>().norm();
    if (away > this->Radius ||
      this->Surface.normal(point).dot(this->Surface.normal(this->Centre)) < ContactTurn)
    {
      // The point is beyond the radius, or on an edge. The other side of the edge limits the disc.
      return;
    }
    if (isHeldAlongNormal(this->Body, point))
    {
      limit(disc, away, PatchStatus::OutOfReach);
      return;
    }
    if (!isWithin(this->Body, point, this->Material))
    {
      limit(disc, away, PatchStatus::Edge);
      return;
    }
    double area = 0.0;
    for (const std::int32_t* t = this->Surface.trianglesBegin(point);
         t != this->Surface.trianglesEnd(point); ++t)
    {
      area += this->Surface.triangleArea(*t) / 3.0;
    }
    disc.points.push_back({ point, at.head<2>(), at[2], area, away });
  }

  const ElasticBody& Body;
  const BodySurface& Surface;
  std::int32_t Centre;
  double Radius;
  Eigen::Matrix3d Frame;
  Eigen::Vector3d Origin; ///< position of the point on the smooth surface
  ElasticMaterial Material;
};
} // namespace

bool isNearlyAlike(const ElasticMaterial& other, const ElasticMaterial& material)
{
  return std::abs(other.youngsModulus / material.youngsModulus - 1.0) <= AlikeModulus &&
    std::abs(other.poissonRatio - material.poissonRatio) <= AlikeRatio;
}

bool isOfOneMaterial(const ElasticBody& body, std::int32_t point)
{
  return isWithin(body, point, body.materialAt(body.surface().node(point)));
}

SurfaceDisc surfaceDisc(const ElasticBody& body, std::int32_t point, double radius)
{
  SurfaceDisc disc;
  const BodySurface& surface = body.surface();
  if (surface.normal(point).isZero() || !(surface.spacing(point) > 0.0))
  {
    disc.status = PatchStatus::Degenerate;
    return disc;
  }
  if (isHeldAlongNormal(body, point))
  {
    disc.status = PatchStatus::OutOfReach;
    return disc;
  }
  bool turns = !isOfOneMaterial(body, point);
  for (const std::int32_t* t = surface.trianglesBegin(point); t != surface.trianglesEnd(point); ++t)
  {
    turns = turns || surface.triangleNormal(*t).dot(surface.normal(point)) < PatchTurn;
  }
  if (turns)
  {
    disc.status = PatchStatus::Edge;
    return disc;
  }
  DiscWalk(body, point, radius).run(disc);
  return disc;
}

std::string whyNotPressed(const ElasticBody& body, std::int32_t point)
{
  if (point < 0 || point >= body.surface().pointTotal())
  {
    return joined(
      "surface point ", point, " does not exist: there are ", body.surface().pointTotal());
  }
  const SurfaceDisc disc = surfaceDisc(body, point, 0.0);
  switch (disc.status)
  {
    case PatchStatus::Valid:
      return {};
    case PatchStatus::Degenerate:
      return joined("surface point ", point, " has no normal");
    case PatchStatus::OutOfReach:
      return joined("surface point ", point, " is held: it cannot be pressed");
    case PatchStatus::Edge:
      break;
  }
  if (!isOfOneMaterial(body, point))
  {
    const std::int32_t node = body.surface().node(point);
    const auto stiffer = [&body](std::int32_t a, std::int32_t b)
    { return body.material(a).youngsModulus < body.material(b).youngsModulus; };
    const auto ends = std::minmax_element(
      body.topology().elementsBegin(node), body.topology().elementsEnd(node), stiffer);
    return joined("surface point ", point, " lies between materials (cells ", *ends.first, " and ",
      *ends.second, "): there is no modulus at it");
  }
  return joined("surface point ", point, " lies on an edge: the surface turns by more than 30°");
}
} // namespace palpate
