// SPDX-License-Identifier: BSD-3-Clause
// Edges that count for a contact, their distance from the contact, and the reduction of the force.
#include "Laws/EdgeDistance.h"
#include "Laws/ErrorRule.h"
#include "Mechanics/Numerics/Constants.h"

#include "Paraboloid.h"
#include "ReferenceTable.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <random>

using namespace palpate;
using palpate::testing::Paraboloid;
using palpate::testing::ReferenceTable;

namespace
{
struct Mesh
{
  std::vector<double> points;
  std::vector<std::int32_t> triangles;

  std::array<double, 3> point(std::size_t i) const
  {
    return { this->points[3 * i], this->points[3 * i + 1], this->points[3 * i + 2] };
  }
  std::size_t size() const { return this->points.size() / 3; }
  TriangleSpans spans() const
  {
    return { this->points.data(), this->size(), this->triangles.data(),
      this->triangles.size() / 3 };
  }
};

using Place = std::function<std::array<double, 3>(double, double)>;

/// n × m squares of two triangles each over [0, 1]², mapped by `place`. The outward normal is u ×
/// v.
Mesh sheet(int n, int m, const Place& place)
{
  Mesh mesh;
  for (int k = 0; k <= m; ++k)
  {
    for (int i = 0; i <= n; ++i)
    {
      const auto at = place(static_cast<double>(i) / n, static_cast<double>(k) / m);
      mesh.points.insert(mesh.points.end(), at.begin(), at.end());
    }
  }
  for (int k = 0; k < m; ++k)
  {
    for (int i = 0; i < n; ++i)
    {
      const std::int32_t a = k * (n + 1) + i;
      const std::int32_t b = a + n + 1;
      mesh.triangles.insert(mesh.triangles.end(), { a, a + 1, b, b, a + 1, b + 1 });
    }
  }
  return mesh;
}

/// A roof: horizontal up to the ridge at x = 0, then sloping down at the angle `fall` (rad). The
/// ridge is rounded with the radius `fillet`.
Mesh roof(double size, int n, double fall, double fillet)
{
  return sheet(n, n,
    [=](double u, double v)
    {
      // The fillet is a function of the arc length s; it begins at -half.
      const double s = (u - 0.5) * size;
      const double half = 0.5 * fillet * fall;
      double x = 0.0;
      double z = 0.0;
      if (s <= -half)
      {
        x = s;
      }
      else if (fillet > 0.0 && s < half)
      {
        const double angle = (s + half) / fillet;
        x = -half + fillet * std::sin(angle);
        z = -fillet * (1.0 - std::cos(angle));
      }
      else
      {
        x = -half + fillet * std::sin(fall) + (s - half) * std::cos(fall);
        z = -fillet * (1.0 - std::cos(fall)) - (s - half) * std::sin(fall);
      }
      return std::array<double, 3>{ x, (v - 0.5) * size, z };
    });
}

/// A cube around the origin with n × n squares per face and shared points.
Mesh cubeOf(double size, int n)
{
  Mesh mesh;
  std::map<std::array<int, 3>, std::int32_t> ids;
  const auto idOf = [&](const std::array<int, 3>& at)
  {
    const auto [found, isNew] = ids.emplace(at, static_cast<std::int32_t>(mesh.size()));
    for (std::size_t k = 0; k < 3 && isNew; ++k)
    {
      mesh.points.push_back(size * (static_cast<double>(at[k]) / n - 0.5));
    }
    return found->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (const int side : { 0, n })
    {
      for (int i = 0; i < n; ++i)
      {
        for (int k = 0; k < n; ++k)
        {
          const auto corner = [&](int u, int v)
          {
            std::array<int, 3> at{};
            at[axis] = side;
            at[(axis + 1) % 3] = u;
            at[(axis + 2) % 3] = v;
            return idOf(at);
          };
          std::array<std::int32_t, 4> c{ corner(i, k), corner(i + 1, k), corner(i + 1, k + 1),
            corner(i, k + 1) };
          if (side == 0)
          {
            std::swap(c[1], c[3]);
          }
          mesh.triangles.insert(mesh.triangles.end(), { c[0], c[1], c[2], c[0], c[2], c[3] });
        }
      }
    }
  }
  return mesh;
}

/// Visits the points whose coordinates are all smaller than `within`, which are away from the
/// border of the sheet.
template <class Visit>
void forInner(const Mesh& mesh, double within, const Visit& visit)
{
  for (std::size_t i = 0; i < mesh.size(); ++i)
  {
    const auto at = mesh.point(i);
    if (std::abs(at[0]) < within && std::abs(at[1]) < within && std::abs(at[2]) < within)
    {
      visit(i, at);
    }
  }
}

Mesh bumpyBall(double radius, double noise)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> even(-noise, noise);
  Mesh mesh = sheet(240, 120,
    [&](double u, double v)
    {
      const double r = radius + even(random);
      const double up = Pi * (0.02 + 0.96 * v);
      return std::array<double, 3>{ r * std::sin(up) * std::cos(2.0 * Pi * u),
        -r * std::sin(up) * std::sin(2.0 * Pi * u), r * std::cos(up) };
    });
  return mesh;
}
} // namespace

TEST(EdgeDistance, OfARoofIsThatToItsRidge)
{
  for (const double fillet : { 0.0, 0.5 })
  {
    const Mesh mesh = roof(60.0, 120, 0.5 * Pi, fillet); // squares of 0.5 mm
    const EdgeDistance edges(mesh.spans(), 2.0, 80.0);
    forInner(mesh, 12.0,
      [&](std::size_t i, const std::array<double, 3>& at)
      {
        const double away = std::max(std::abs(at[0]), std::abs(at[2]));
        // Distance to the nearest side of the fillet, plus one square. Cells of 6 mm, used from 8
        // mm on, make the fillet sharper.
        EXPECT_NEAR(static_cast<double>(edges.at(i).distance), away, 3.0 * fillet + 0.51) << away;
        // Cells of 2 mm contain the whole fillet, except where the fillet crosses a cell.
        EXPECT_NEAR(static_cast<double>(edges.at(i).turn), 0.5 * Pi, fillet > 0.0 ? 0.5 : 1e-3);
      });
  }
}

TEST(EdgeDistance, OfLongFacetsToo)
{
  const Mesh mesh = roof(60.0, 2, 0.25 * Pi, 0.0); // a ridge, and two borders at 30 mm
  // reach of a sharp edge; an edge of 45° has one fifth of this reach
  const EdgeDistance edges(mesh.spans(), 1.0, 160.0);
  EXPECT_EQ(edges.at(1).border, 0.0F);
  EXPECT_NEAR(static_cast<double>(edges.at(4).distance), 0.0, 1e-6);
  EXPECT_NEAR(static_cast<double>(edges.at(4).turn), 0.25 * Pi, 1e-6);
  EXPECT_NEAR(static_cast<double>(edges.at(3).distance), 30.0, 1e-4);
}

/// A ball has no edge and a cube has its twelve edges, for any orientation of the mesh.
TEST(EdgeDistance, DoesNotDependOnTheAxes)
{
  std::mt19937 random(9);
  std::normal_distribution<double> any;
  const auto turned = [&](Mesh mesh)
  {
    const Eigen::Quaterniond turn =
      Eigen::Quaterniond(any(random), any(random), any(random), any(random)).normalized();
    const Eigen::Vector3d shift(any(random), any(random), any(random));
    for (std::size_t i = 0; i < mesh.size(); ++i)
    {
      Eigen::Map<Eigen::Vector3d> at(mesh.points.data() + 3 * i);
      at = turn * Eigen::Vector3d(at) + shift;
    }
    return mesh;
  };
  const Mesh ball = bumpyBall(8.0, 0.0);
  const Mesh cube = cubeOf(40.0, 20);
  constexpr int trials = 24;
  std::size_t wrong = 0;
  for (int trial = 0; trial < trials; ++trial)
  {
    for (const double radius : { 0.6, 1.3, 1.7 })
    {
      EXPECT_EQ(EdgeDistance(turned(ball).spans(), radius, 40.0 * radius).edges(), 0U) << radius;
    }
    const EdgeDistance edges(turned(cube).spans(), 1.2, 48.0);
    for (std::size_t i = 0; i < cube.size(); ++i)
    {
      auto inward = cube.point(i); // distance from the nearest edge: the second smallest
      for (double& x : inward)
      {
        x = 20.0 - std::abs(x);
      }
      std::sort(inward.begin(), inward.end());
      const bool isRight = std::abs(static_cast<double>(edges.at(i).distance) - inward[1]) < 1e-3 &&
        std::abs(static_cast<double>(edges.at(i).turn) - 0.5 * Pi) < 0.02;
      wrong += !isRight;
    }
  }
  EXPECT_EQ(wrong, 0U);
}

/// Small turns, hollows, balls and noise do not count as edges.
TEST(EdgeDistance, WhatIsNoEdge)
{
  const auto innerEdges = [](const Mesh& mesh, double a)
  { return EdgeDistance(mesh.spans(), a, 5.0).edges(); };
  EXPECT_EQ(innerEdges(roof(60.0, 120, 0.3, 0.0), 2.0), 0U);
  EXPECT_EQ(innerEdges(roof(60.0, 120, -0.5 * Pi, 0.0), 2.0), 0U);
  EXPECT_GT(innerEdges(roof(60.0, 120, 0.5, 0.0), 2.0), 0U);
  EXPECT_EQ(innerEdges(bumpyBall(20.0, 0.0), 2.0), 0U);
  EXPECT_EQ(innerEdges(bumpyBall(20.0, 0.0), 4.0), 0U);
  // Noise of a scan: facets of 0.5 mm that are tilted by up to 30°.
  EXPECT_EQ(innerEdges(bumpyBall(20.0, 0.05), 2.0), 0U);
}

TEST(EdgeDistance, BorderCountsSlitsAndHolesDoNot)
{
  Mesh mesh = sheet(60, 60,
    [](double u, double v) {
      return std::array<double, 3>{ 60.0 * u, 60.0 * v, 0.0 };
    });
  const std::size_t middle = 30 * 61 + 30;
  EXPECT_NEAR(
    static_cast<double>(EdgeDistance(mesh.spans(), 1.0, 80.0).at(middle).border), 30.0, 1e-4);
  // A hole of one square, 2 mm from the middle; and a slit whose two sides have the same position.
  Mesh holed = mesh;
  holed.triangles.erase(
    holed.triangles.begin() + 6 * (30 * 60 + 32), holed.triangles.begin() + 6 * (30 * 60 + 32) + 6);
  EXPECT_NEAR(
    static_cast<double>(EdgeDistance(holed.spans(), 1.0, 80.0).at(middle).border), 30.0, 1e-4);
  Mesh slit = mesh;
  std::map<std::int32_t, std::int32_t> twin;
  for (std::int32_t k = 0; k <= 60; ++k)
  {
    const std::int32_t point = k * 61 + 40;
    twin[point] = static_cast<std::int32_t>(slit.size());
    const auto at = mesh.point(static_cast<std::size_t>(point));
    slit.points.insert(slit.points.end(), at.begin(), at.end());
  }
  for (std::size_t corner = 0; corner < slit.triangles.size(); ++corner)
  {
    const bool isRight = (corner / 6) % 60 >= 40;
    const auto found = twin.find(slit.triangles[corner]);
    slit.triangles[corner] =
      isRight && found != twin.end() ? found->second : slit.triangles[corner];
  }
  // The point is 10 mm from the slit and 20 mm from the border on the other side of the slit.
  EXPECT_NEAR(
    static_cast<double>(EdgeDistance(slit.spans(), 1.0, 80.0).at(30 * 61 + 39).border), 30.0, 9.1);
  EXPECT_GT(EdgeDistance(slit.spans(), 1.0, 80.0).at(30 * 61 + 39).border, 20.0F);
}

/// Φ of Hetényi's quarter space, for a flat end, a paraboloid and a cone.
TEST(EdgeDistance, FactorIsThatOfAQuarterSpace)
{
  const ReferenceTable table("edges/edge_law.csv");
  int rows = 0;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double u = table.number(row, "u=d/a0");
    if (u >= 0.0)
    {
      // One curve represents the three tools, whose factors differ by up to 0.03.
      EXPECT_NEAR(edgeFactor(table.number(row, "nu"), u, 1.0), table.number(row, "Phi=F/F0"), 0.028)
        << table.number(row, "nu") << ", m " << table.number(row, "m") << ", u " << u;
      ++rows;
    }
  }
  EXPECT_GT(rows, 90);
  // Far from the edge the factor is that of a point load: 1 - Φ = ψ/(πu).
  EXPECT_NEAR((1.0 - edgeFactor(0.3, 100.0, 1.0)) * 100.0 * Pi, 1.8448, 0.012);
}

/// Wedges of other angles against finite elements: the sharpness is at least that of the elements
/// and of the same size.
TEST(EdgeDistance, SharpnessIsThatOfWedges)
{
  const ReferenceTable table("edges/wedge_point_law.csv");
  const auto psi = [&](std::size_t row)
  { return table.number(row, "psi (C_edge=psi/(2 pi E* d))"); };
  std::map<double, double> right;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    if (table.number(row, "turn_deg") == 90.0)
    {
      right[table.number(row, "nu")] = psi(row);
    }
  }
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double nu = table.number(row, "nu");
    const double turn = table.number(row, "turn_deg");
    const double sharpness = edgeSharpness(nu, turn * Pi / 180.0);
    const double found = psi(row) / right[nu];
    EXPECT_GE(sharpness, 0.97 * found - 0.003) << nu << ", " << turn; // 0.97: error of the elements
    EXPECT_LE(sharpness, std::max(1.4 * found, found + 0.13)) << nu << ", " << turn;
  }
  EXPECT_EQ(table.size(), 24U);
  EXPECT_EQ(edgeSharpness(0.3, 3.0), edgeSharpness(0.3, 2.0 * Pi / 3.0));
}

/// A step up with a ridge on top. For a point at the foot of the step the ridge is not an edge,
/// since the body continues under the ridge.
TEST(EdgeDistance, WhatRisesAboveTheSurfaceIsNoneForIt)
{
  constexpr double rise = 6.0; // mm; a slope of 45° from x = 20 on, its ridge, and a vertical drop
  const Mesh mesh = sheet(80, 40,
    [=](double u, double v)
    {
      const double s = 40.0 * u;
      const double x = s < 20.0 ? s : std::min(20.0 + (s - 20.0), 20.0 + rise);
      const double z = s < 20.0 ? 0.0 : s < 20.0 + rise ? s - 20.0 : 2.0 * rise - (s - 20.0);
      return std::array<double, 3>{ x, 40.0 * v, z };
    });
  const EdgeDistance edges(mesh.spans(), 1.0, 80.0);
  const auto pointAt = [](std::int32_t i) { return static_cast<std::size_t>(20 * 81 + i); };
  // For points on the slope the ridge is an edge of 135°. Points on the horizontal part, 4 mm
  // before the foot, see a surface that rises by 31° and thus no edge.
  EXPECT_NEAR(static_cast<double>(edges.at(pointAt(48)).distance), 2.0 * std::sqrt(2.0), 0.8);
  EXPECT_EQ(edges.at(pointAt(32)).distance, NearEdge::Far);
}

/// The part Edge of the error: it depends on the angle, is smaller on a layer, and is zero if the
/// body's own compliance is known.
TEST(EdgeDistance, PartOfTheError)
{
  const Paraboloid shape;
  const auto tool = shape.make();
  const ErrorRule rule(*tool, { false, nullptr, 1000.0, 0.0 });
  const double a = 1.0;
  const double depth = shape.depthAt(a);
  const LocalState state{ depth, shape.force(depth, 1.0), 2.0 * a, a };
  const auto part = [&](double compliance, double thickness, const NearEdge& edge)
  {
    return rule.at(
      { 0.5, 0.45, compliance, thickness, {} }, { {}, edge }, state)[ResponseLimit::Edge];
  };
  const auto right = static_cast<float>(0.5 * Pi);
  const double whole = 1.0 - edgeFactor(0.45, 3.0, 1.0);
  EXPECT_NEAR(part(0.0, 0.0, { 3.0F, right, NearEdge::Far }), whole, 1e-6);
  EXPECT_NEAR(part(0.0, 0.0, { 3.0F, 0.5F * right, NearEdge::Far }),
    1.0 - edgeFactor(0.45, 3.0, edgeSharpness(0.45, 0.25 * Pi)), 1e-6);
  EXPECT_NEAR(part(0.0, 6.0, { 3.0F, right, NearEdge::Far }), std::exp(-0.5) * whole, 1e-6);
  EXPECT_EQ(part(0.1, 0.0, { 3.0F, right, NearEdge::Far }), 0.0);
  EXPECT_EQ(part(0.0, 0.0, {}), 0.0);
  // A border: the whole part at the border, half of the part one contact radius away, zero from two
  // radii on.
  const auto atBorder = [](float border) { return NearEdge{ NearEdge::Far, 0.0F, border }; };
  EXPECT_NEAR(part(0.0, 0.0, atBorder(0.0F)), 1.0 - edgeFactor(0.45, 0.0, 1.0), 1e-6);
  EXPECT_NEAR(part(0.0, 0.0, atBorder(1.0F)), 0.5 * (1.0 - edgeFactor(0.45, 1.0, 1.0)), 1e-6);
  EXPECT_EQ(part(0.0, 0.0, atBorder(2.0F)), 0.0);
}
