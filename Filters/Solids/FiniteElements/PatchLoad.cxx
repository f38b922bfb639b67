// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/FiniteElements/PatchLoad.h"
#include "Mechanics/Numerics/Constants.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
/// Returns the triangles around `point`, up to the nearest edges, that a disc of the given radius
/// may cover.
std::vector<std::int32_t> trianglesUnder(
  const BodySurface& surface, std::int32_t point, const Eigen::Matrix3d& frame, double radius)
{
  const Eigen::Vector3d normal = -frame.col(2);
  const Eigen::Vector3d& centre = surface.position(point);
  std::vector<std::int32_t> found;
  std::vector<std::int32_t> points = { point };
  std::vector<std::int32_t> seen = { point };
  for (std::size_t next = 0; next < points.size(); ++next)
  {
    const std::int32_t from = points[next];
    for (const std::int32_t* t = surface.trianglesBegin(from); t != surface.trianglesEnd(from); ++t)
    {
      if (std::find(found.begin(), found.end(), *t) != found.end() ||
        surface.triangleNormal(*t).dot(normal) < PatchTurn)
      {
        continue;
      }
      const auto& corners = surface.triangle(*t);
      Eigen::Vector2d middle = Eigen::Vector2d::Zero();
      std::array<Eigen::Vector2d, 3> flat;
      for (std::size_t i = 0; i < 3; ++i)
      {
        flat[i] = frame.leftCols<2>().transpose() * (surface.position(corners[i]) - centre);
        middle += flat[i] / 3.0;
      }
      double extent = 0.0;
      for (const Eigen::Vector2d& corner : flat)
      {
        extent = std::max(extent, (corner - middle).norm());
      }
      if (middle.norm() - extent > radius)
      {
        continue;
      }
      found.push_back(*t);
      for (const std::int32_t corner : corners)
      {
        if (std::find(seen.begin(), seen.end(), corner) == seen.end())
        {
          seen.push_back(corner);
          points.push_back(corner);
        }
      }
    }
  }
  return found;
}

/// Returns the barycentric coordinates of a point of the tangent plane in a triangle that is
/// projected along the normal.
Eigen::Vector3d barycentric(const std::array<Eigen::Vector2d, 3>& corner, const Eigen::Vector2d& at)
{
  const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b)
  { return a[0] * b[1] - a[1] * b[0]; };
  const double area = cross(corner[1] - corner[0], corner[2] - corner[0]);
  Eigen::Vector3d l;
  l[1] = cross(at - corner[0], corner[2] - corner[0]) / area;
  l[2] = cross(corner[1] - corner[0], at - corner[0]) / area;
  l[0] = 1.0 - l[1] - l[2];
  return l;
}
} // namespace

const DiscRule& DiscRule::standard()
{
  static const DiscRule rule = []
  {
    DiscRule made;
    // The rule is Gauss-Legendre in the square of the radius, with eight angles per ring. The
    // middle ring is rotated.
    const std::array<double, 3> square = { 0.5 - 0.5 * std::sqrt(0.6), 0.5,
      0.5 + 0.5 * std::sqrt(0.6) };
    const std::array<double, 3> ofRing = { 5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0 };
    for (std::size_t i = 0; i < Count; ++i)
    {
      const std::size_t ring = i / 8;
      const double angle = Pi * (static_cast<double>(i % 8) / 4.0 + (ring == 1 ? 0.125 : 0.0));
      made.at[i] = std::sqrt(square[ring]) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      made.weights[i] = ofRing[ring] / 8.0;
    }
    return made;
  }();
  return rule;
}

Eigen::Matrix3d tangentFrame(const Eigen::Vector3d& outwardNormal)
{
  // Tiny components are set to 0, so that rounding does not decide which axis is the farthest from
  // the normal.
  const Eigen::Vector3d inward =
    (outwardNormal.array().abs() < 1e-12).select(0.0, -outwardNormal).matrix();
  Eigen::Index smallest = 0;
  inward.cwiseAbs().minCoeff(&smallest);
  Eigen::Matrix3d frame;
  frame.col(0) = Eigen::Vector3d::Unit(smallest).cross(inward).normalized();
  frame.col(1) = inward.cross(frame.col(0));
  frame.col(2) = inward;
  return frame;
}

PatchLoad makePatchLoad(
  const VolumeMesh& mesh, const BodySurface& surface, std::int32_t point, double radius)
{
  PatchLoad load;
  const Eigen::Matrix3d frame = tangentFrame(surface.normal(point));
  const std::vector<std::int32_t> triangles = trianglesUnder(surface, point, frame, radius);
  std::vector<std::array<Eigen::Vector2d, 3>> flat(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      flat[t][i] = frame.leftCols<2>().transpose() *
        (surface.position(surface.triangle(triangles[t])[i]) - surface.position(point));
    }
  }
  const DiscRule& rule = DiscRule::standard();
  for (std::size_t q = 0; q < DiscRule::Count; ++q)
  {
    // The following loop finds the triangle that contains the point. If the point is on a common
    // edge, the triangle with the largest smallest coordinate is chosen.
    double deepest = -1e-9;
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    std::int32_t in = -1;
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      const Eigen::Vector3d l = barycentric(flat[t], radius * rule.at[q]);
      if (l.minCoeff() > deepest)
      {
        deepest = l.minCoeff();
        at = l;
        in = triangles[t];
      }
    }
    if (in < 0)
    {
      return load;
    }
    const SurfacePlace place = surface.place(in, at);
    load.places[q].setZero();
    for (std::size_t i = 0; i < static_cast<std::size_t>(place.count); ++i)
    {
      load.nodes.emplace_back(place.nodes[i], rule.weights[q] * place.shape[i]);
      load.places[q] += place.shape[i] * mesh.nodes.col(place.nodes[i]);
    }
  }
  std::stable_sort(load.nodes.begin(), load.nodes.end(),
    [](const auto& a, const auto& b) { return a.first < b.first; });
  std::size_t kept = 0;
  for (std::size_t i = 1; i < load.nodes.size(); ++i)
  {
    if (load.nodes[i].first == load.nodes[kept].first)
    {
      load.nodes[kept].second += load.nodes[i].second;
    }
    else
    {
      load.nodes[++kept] = load.nodes[i];
    }
  }
  load.nodes.resize(kept + 1);
  load.complete = true;
  return load;
}
} // namespace palpate
