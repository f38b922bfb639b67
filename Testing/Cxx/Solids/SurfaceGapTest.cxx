// SPDX-License-Identifier: BSD-3-Clause
// Contacts on a half-space with an uneven surface, to second order and solved (UnevenContact):
// inclined planes and unequal curvatures in closed form, and random waves against square cells with
// an active set, a method without rings and harmonics.
#include "Mechanics/Numerics/Constants.h"
#include "Solids/TrueShape/ShapedContact.h"
#include "Solids/TrueShape/UnevenContact.h"
#include "TestTools.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <random>

namespace
{
using namespace palpate;
using palpate::testing::tool;

using Height = std::function<double(const Eigen::Vector2d&)>; // depth below the tangent plane, mm

SurfaceGap surfaceOf(const Height& height, double radius)
{
  SurfaceGap::Heights heights;
  for (int k = 0; k < SurfaceGap::Rings; ++k)
  {
    for (int j = 0; j < SurfaceGap::Angles; ++j)
    {
      const double angle = 2.0 * Pi * j / SurfaceGap::Angles;
      heights.surface(k, j) =
        height(radius * SurfaceGap::ring(k) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
  }
  heights.facets = heights.surface;
  return SurfaceGap(radius, heights);
}

enum class Way
{
  SecondOrder,
  Solved
};

/// Kernels of a half-space with this surface.
class Shaped : public ContactKernels
{
public:
  Shaped(const Height& height, double radius, Way way)
    : Gap(surfaceOf(height, radius))
    , Taken(way)
  {
    this->Site.status = PatchStatus::Valid;
    this->Site.reducedModulus = 1.0;
    this->Site.largestRadius = radius;
    this->Site.limit = Infinity;
    this->Site.elements = { 0.0, 0.0 };
    this->Site.spacing = 1.0;
  }

  ContactKernel at(double radius, int) const override
  {
    ContactKernel kernel;
    kernel.order = 1;
    kernel.gap = this->Gap.at(radius);
    return kernel;
  }

  const SurfaceGap* surface() const override
  {
    return this->Taken == Way::Solved ? &this->Gap : nullptr;
  }

private:
  SurfaceGap Gap;
  Way Taken;
};

/// Error of a solved contact from its cells.
double ofCells(Way way)
{
  return way == Way::Solved ? 2e-3 : 0.0;
}

/// The force for E* = 1 from square cells of uniform pressure (Love 1929) and an iterated active
/// set.
double cellForce(
  const AxisymmetricTool& pressed, const Height& height, double depth, double extent, double side)
{
  const auto term = [](double x, double y)
  { return x * std::log(y + std::hypot(x, y)) + y * std::log(x + std::hypot(x, y)); };
  const auto love = [&](const Eigen::Vector2d& at)
  {
    const double x = at[0];
    const double y = at[1];
    const double h = 0.5 * side;
    return (term(x + h, y + h) + term(x - h, y - h) - term(x + h, y - h) - term(x - h, y + h)) / Pi;
  };
  std::vector<Eigen::Vector2d> cells;
  std::vector<double> sinks;
  const int n = static_cast<int>(std::ceil(extent / side));
  for (int i = -n; i < n; ++i)
  {
    for (int j = -n; j < n; ++j)
    {
      const Eigen::Vector2d at = side * Eigen::Vector2d(i + 0.5, j + 0.5);
      const double sink = at.norm() < std::min(extent, pressed.largestContactRadius())
        ? depth - pressed.profile(at.norm()) - height(at)
        : -1.0;
      if (sink > 0.0)
      {
        cells.push_back(at);
        sinks.push_back(sink);
      }
    }
  }
  double force = 0.0;
  for (int turn = 0; turn < 60; ++turn)
  {
    const auto count = static_cast<Eigen::Index>(cells.size());
    Eigen::MatrixXd system(count, count);
    for (Eigen::Index i = 0; i < count; ++i)
    {
      for (Eigen::Index j = 0; j < count; ++j)
      {
        system(i, j) =
          love(cells[static_cast<std::size_t>(i)] - cells[static_cast<std::size_t>(j)]);
      }
    }
    const Eigen::VectorXd pressures =
      system.partialPivLu().solve(Eigen::Map<const Eigen::VectorXd>(sinks.data(), count));
    force = side * side * pressures.sum();
    std::vector<Eigen::Vector2d> kept;
    std::vector<double> keptSinks;
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      if (pressures[static_cast<Eigen::Index>(i)] > 0.0)
      {
        kept.push_back(cells[i]);
        keptSinks.push_back(sinks[i]);
      }
    }
    if (kept.size() == cells.size())
    {
      break;
    }
    cells.swap(kept);
    sinks.swap(keptSinks);
  }
  return force;
}
} // namespace

class SurfaceGapOf : public ::testing::TestWithParam<Way>
{
};

INSTANTIATE_TEST_SUITE_P(Ways, SurfaceGapOf, ::testing::Values(Way::SecondOrder, Way::Solved),
  [](const ::testing::TestParamInfo<Way>& way)
  { return way.param == Way::Solved ? "Solved" : "SecondOrder"; });

// A paraboloid on a plane inclined by s acts as a paraboloid that is R s²/2 deeper and shifted
// sideways.
TEST_P(SurfaceGapOf, APlaneThatLeans)
{
  constexpr double radius = 6.35;
  const auto pressed = tool("paraboloid:6.35");
  for (const double slope : { 0.05, 0.1, 0.2 })
  {
    const Shaped kernels(
      [slope](const Eigen::Vector2d& at) { return slope * at[1]; }, 5.0, GetParam());
    const ContactCurve curve = ShapedContact(*pressed).curve(kernels);
    for (const double depth : { 0.5, 1.0 })
    {
      const double more = 0.5 * radius * slope * slope / depth;
      const double exact = 4.0 / 3.0 * std::sqrt(radius) * std::pow(depth * (1.0 + more), 1.5);
      const double error = std::abs(curve.evaluate(depth).force / exact - 1.0);
      // The error of the second-order method is of fourth order in the slope: 3/8 of the square of
      // the added part.
      const double left = GetParam() == Way::Solved ? 0.0 : 0.5 * more * more;
      EXPECT_LT(error, left + ofCells(GetParam()) + 1e-4) << slope << ' ' << depth;
      EXPECT_LT(error, curve.errorsAt(depth).gap + 1e-4) << slope << ' ' << depth;
    }
  }
}

// Hertz: an elliptic contact with the same mean curvature.
TEST_P(SurfaceGapOf, UnequalCurvatures)
{
  const auto pressed = tool("paraboloid:6.35");
  for (const double ratio : { 0.9, 0.7, 0.5, 0.35 }) // ratio of the axes of the ellipse
  {
    const double e2 = 1.0 - ratio * ratio; // square of the eccentricity
    const double k = std::comp_ellint_1(std::sqrt(e2));
    const double e = std::comp_ellint_2(std::sqrt(e2));
    // Johnson 1985, 4.26: half curvatures A, B and depth for the long half axis a = 1, all divided
    // by p₀/E*.
    const double low = ratio / e2 * (k - e);
    const double high = ratio / e2 * (e / (ratio * ratio) - k);
    const double deep = ratio * k;
    const double push = 2.0 / 3.0 * Pi * ratio;
    // Scaled to the combined mean curvature of tool and body at a depth of 1: lengths by l, heights
    // by l².
    constexpr double curvature = 1.0 / 6.35 + 0.05;
    const double length = std::sqrt((low + high) / (deep * curvature));
    const double exact = push / deep * length;
    // half the difference of the curvatures
    const double unequal = (high - low) / (high + low) * curvature;
    const Shaped kernels([unequal](const Eigen::Vector2d& at)
      { return 0.5 * (0.05 + unequal) * at[0] * at[0] + 0.5 * (0.05 - unequal) * at[1] * at[1]; },
      5.5, GetParam());
    const ContactCurve curve = ShapedContact(*pressed).curve(kernels);
    const double error = std::abs(curve.evaluate(1.0).force / exact - 1.0);
    const double part = std::pow(unequal / curvature, 2) / 3.0;
    const double left = GetParam() == Way::Solved ? 0.0 : 2.0 * part * part; // fourth-order error
    EXPECT_LT(error, left + 1.5 * ofCells(GetParam()) + 2e-4) << ratio;
    EXPECT_LT(error, curve.errorsAt(1.0).gap + 2e-4) << ratio;
    EXPECT_GT(part, ratio < 0.8 ? 0.01 : 0.0); // the effect is measurable
  }
}

// The cells rotate and shift with the contact. A surface of revolution has no effect.
TEST(UnevenContact, ATurnedSurfaceIsFeltAlike)
{
  const auto pressed = tool("sphere:6.35");
  const auto changeAt = [&](double turn)
  {
    const SurfaceGap gap = surfaceOf(
      [turn](const Eigen::Vector2d& at)
      {
        const Eigen::Vector2d p = Eigen::Rotation2Dd(turn) * at;
        return 0.1 * p[0] + 0.04 * p[0] * p[0] - 0.02 * p[1] * p[1] + 0.01 * p[0] * p[0] * p[1];
      },
      4.0);
    return UnevenContact(*pressed, gap)
      .at(2.0, pressed->force(pressed->depthAtContactRadius(2.0), 1.0));
  };
  const UnevenContact::Change straight = changeAt(0.0);
  EXPECT_TRUE(straight.isInside);
  EXPECT_LT(straight.deflection, -0.02); // the higher part of the surface is pressed first
  for (const double turn : { 0.3, 0.8, 2.5 })
  {
    // Tolerance: the stated error of the cells.
    EXPECT_NEAR(changeAt(turn).deflection, straight.deflection, 0.05 * -straight.deflection)
      << turn;
  }
  const SurfaceGap round =
    surfaceOf([](const Eigen::Vector2d& at) { return 0.05 * at.squaredNorm(); }, 4.0);
  EXPECT_NEAR(UnevenContact(*pressed, round).at(2.0, 3.0).deflection, 0.0, 1e-6);
}

// A flat end on a plane inclined by s first touches with one cell of its rim, s a before its middle
// touches. From a depth of 2 s a on the contact is as on a plane that is not inclined.
TEST(UnevenContact, APunchThatBeginsAtOnePointOfItsRimCloses)
{
  const auto pressed = tool("flat:1.6");
  const double radius = std::nextafter(1.6, 0.0);
  const Eigen::Vector2d slope = 0.3 * Eigen::Vector2d(std::cos(0.4), std::sin(0.4));
  const SurfaceGap gap = surfaceOf([&](const Eigen::Vector2d& at) { return slope.dot(at); }, 4.0);
  UnevenContact uneven(*pressed, gap);
  double before = -0.3 * 1.6;
  for (const double depth : { 0.001, 0.01, 0.05, 0.2, 0.5 })
  {
    const double later = uneven.at(radius, 2.0 * 1.6 * depth).deflection;
    EXPECT_GT(later, before) << depth;
    before = later;
  }
  EXPECT_LT(before, 0.0);
  // solved in single precision
  EXPECT_NEAR(uneven.at(radius, 2.0 * 1.6 * 1.1).deflection, 0.0, 1e-4);
}

// A contact that leaves the known surface reports this.
TEST(UnevenContact, TheEndOfTheSurfaceIsTold)
{
  const auto pressed = tool("sphere:6.35");
  const Height leaning = [](const Eigen::Vector2d& at) { return 0.3 * at[0]; };
  const double load = pressed->force(pressed->depthAtContactRadius(1.5), 1.0);
  const SurfaceGap wide = surfaceOf(leaning, 4.5);
  EXPECT_TRUE(UnevenContact(*pressed, wide).at(1.5, load).isInside);
  const SurfaceGap narrow = surfaceOf(leaning, 2.0);
  EXPECT_FALSE(UnevenContact(*pressed, narrow).at(1.5, load).isInside);
  const Height uneven = [](const Eigen::Vector2d& at)
  { return 0.1 * at[0] + 0.02 * (at[0] * at[0] - at[1] * at[1]); };
  const SurfaceGap enough = surfaceOf(uneven, SurfaceGap::reachFor(1.5));
  EXPECT_TRUE(UnevenContact(*pressed, enough).at(1.5, load).isInside);
  const SurfaceGap under = surfaceOf(uneven, 1.5); // only the contact on the mean surface is known
  EXPECT_FALSE(UnevenContact(*pressed, under).at(1.5, load).isInside);
}

// Surfaces of six waves each, with wavelengths of at least 1.5 mm, that change the force by up to
// one half. The stated error is a bound in 19 of 20 cases, and the error of the law is a small part
// of the effect of the shape.
TEST_P(SurfaceGapOf, WavesDrawnAtRandom)
{
  struct Wave
  {
    Eigen::Vector2d number; // wave vector, 1/mm
    double phase;
    double height;
  };
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  int beyond = 0;
  int all = 0;
  double changed = 0.0;
  double wrong = 0.0;
  for (const char* name : { "sphere:6.35", "sphere:1.6", "flat:1.6", "cone:60" })
  {
    const auto pressed = tool(name);
    for (int k = 0; k < 15; ++k)
    {
      const double amplitude = 0.02 * std::pow(2.0, k % 4);
      const double shortest = 1.5 * std::pow(2.0, k % 3);
      std::vector<Wave> waves;
      double level = 0.0;
      Eigen::Vector2d slope = Eigen::Vector2d::Zero();
      for (int w = 0; w < 6; ++w)
      {
        const double length = shortest * std::pow(8.0, uniform(random));
        const double turn = 2.0 * Pi * uniform(random);
        waves.push_back({ 2.0 * Pi / length * Eigen::Vector2d(std::cos(turn), std::sin(turn)),
          2.0 * Pi * uniform(random), amplitude * normal(random) * length / 8.0 });
        level += waves.back().height * std::sin(waves.back().phase);
        slope += waves.back().height * std::cos(waves.back().phase) * waves.back().number;
      }
      // The normal of a vertex is nearly that of the surface: a third of the slope remains.
      const Height height = [=](const Eigen::Vector2d& at)
      {
        double sum = -level - 0.7 * slope.dot(at);
        for (const Wave& wave : waves)
        {
          sum += wave.height * std::sin(wave.phase + wave.number.dot(at));
        }
        return sum;
      };
      const double depth = k % 2 == 0 ? 1.0 : 0.3;
      const Shaped kernels(height, 1.42 * pressed->contactRadius(depth), GetParam());
      const ContactCurve curve = ShapedContact(*pressed).curve(kernels);
      if (curve.isEmpty() || !(depth < curve.deepest()))
      {
        continue; // such depths are beyond the stated range
      }
      // The error of the cells is that on a plane, where it is known.
      const double side = pressed->contactRadius(depth) / 8.0;
      const double extent = 1.6 * pressed->contactRadius(depth);
      const double plane = pressed->force(depth, 1.0);
      const double scale = plane /
        cellForce(
          *pressed, [](const Eigen::Vector2d&) { return 0.0; }, depth, extent, side);
      const double truth = scale * cellForce(*pressed, height, depth, extent, side);
      const double error = std::abs(curve.evaluate(depth).force / truth - 1.0);
      constexpr double ofTruth = 1e-3; // change with cells of half the side
      ++all;
      beyond += error > curve.errorsAt(depth).gap + ofTruth ? 1 : 0;
      changed += std::abs(truth / plane - 1.0);
      wrong += error;
    }
  }
  std::cout << beyond << " of " << all << " beyond what is stated; shape changes the force by "
            << changed / all << ", the law is off by " << wrong / all << "\n";
  EXPECT_GE(all, 50);
  EXPECT_LE(beyond, 0.05 * all);
  EXPECT_LT(wrong, (GetParam() == Way::Solved ? 0.05 : 0.1) * changed);
}
