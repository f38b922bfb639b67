// SPDX-License-Identifier: BSD-3-Clause
// Properties of every rigid tool of revolution on a half-space, for any shape.
#include "Agreement.h"
#include "Quadrature.h"
#include "TestTools.h"

#include <string>

using palpate::Pi;
using palpate::testing::agrees;
using palpate::testing::Quadrature;
using palpate::testing::Rubber;

namespace
{
/// ∫ f dr over 0..end, split at the kinks, with 400 points per part and the substitution r = p +
/// (q-p) v² (3-2v). It makes an inverse square root at an end smooth. A logarithm becomes v log v,
/// for which 400 points have an error of 1e-10.
template <class Function>
double integrateBetweenKinks(const std::vector<double>& kinks, double end, Function&& f)
{
  static const Quadrature rule(400);
  std::vector<double> ends = { 0.0 };
  for (const double kink : kinks)
  {
    if (kink < end)
    {
      ends.push_back(kink);
    }
  }
  ends.push_back(end);
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
  {
    const double p = ends[i];
    const double whole = ends[i + 1] - p;
    sum += rule.integrate(0.0, 1.0,
      [&](double v)
      { return f(p + whole * v * v * (3.0 - 2.0 * v)) * whole * 6.0 * v * (1.0 - v); });
  }
  return sum;
}
} // namespace

class HalfSpaceInvariants : public ::testing::TestWithParam<const char*>
{
protected:
  std::unique_ptr<palpate::AxisymmetricTool> Tool = palpate::testing::tool(this->GetParam());
};

TEST_P(HalfSpaceInvariants, StiffnessIsTheSlopeOfTheForce)
{
  for (const double depth : { 1e-3, 0.05, 0.3, 1.0, 2.5 })
  {
    const auto difference = [&](double h)
    {
      return (this->Tool->force(depth + h, Rubber) - this->Tool->force(depth - h, Rubber)) /
        (2.0 * h);
    };
    const double h = 1e-3 * depth;
    const double slope = (4.0 * difference(0.5 * h) - difference(h)) / 3.0;
    // Richardson extrapolation: truncation (h/δ)⁴ = 1e-12, rounding 1e-16 δ/h = 1e-13, both times a
    // small factor.
    EXPECT_TRUE(agrees(this->Tool->stiffness(depth, Rubber), slope, 2e-11)) << depth;
  }
}

TEST_P(HalfSpaceInvariants, StiffnessIsTwiceModulusTimesRadius)
{
  for (const double depth : { 1e-6, 0.05, 1.0 })
  {
    EXPECT_EQ(this->Tool->stiffness(depth, 1.0), 2.0 * this->Tool->contactRadius(depth));
    EXPECT_TRUE(agrees(
      this->Tool->stiffness(depth, Rubber), Rubber * this->Tool->stiffness(depth, 1.0), 1e-15));
  }
}

TEST_P(HalfSpaceInvariants, PressureCarriesTheForce)
{
  for (const double depth : { 0.05, 0.5, 1.5 })
  {
    const double carried =
      integrateBetweenKinks(this->Tool->kinks(), this->Tool->contactRadius(depth),
        [&](double r) { return this->Tool->pressure(r, depth, Rubber) * 2.0 * Pi * r; });
    // Near a rim the rounding of a²-r² is 1e-16/(1-r/a): 1e-10 of the whole force.
    EXPECT_TRUE(agrees(carried, this->Tool->force(depth, Rubber), 1e-9)) << depth;
  }
}

TEST_P(HalfSpaceInvariants, LoadInsideIsTheIntegralOfThePressure)
{
  const double depth = 0.5;
  const double a = this->Tool->contactRadius(depth);
  for (const double share : { 0.01, 0.3, 0.9 })
  {
    const double r = share * a;
    const double carried = integrateBetweenKinks(this->Tool->kinks(), r,
      [&](double at) { return this->Tool->pressure(at, depth, Rubber) * 2.0 * Pi * at; });
    // At ν = 0: u_r = -F(r)/(2πE* r).
    const double load =
      -this->Tool->surfaceDisplacement(r, depth, 0.0).radial * 2.0 * Pi * Rubber * r;
    EXPECT_TRUE(agrees(load, carried, 1e-9)) << share;
  }
}

TEST_P(HalfSpaceInvariants, SurfaceTakesTheShapeOfTheToolInside)
{
  const double depth = 0.4;
  const double a = this->Tool->contactRadius(depth);
  for (const double share : { 0.0, 0.2, 0.7, 1.0 })
  {
    const double r = share * a;
    EXPECT_EQ(
      this->Tool->surfaceDisplacement(r, depth, 0.3).normal, depth - this->Tool->profile(r));
  }
}

TEST_P(HalfSpaceInvariants, NormalDisplacementIsContinuousAtTheRim)
{
  for (const double depth : { 0.01, 0.5, 2.0 })
  {
    const double a = this->Tool->contactRadius(depth);
    // the contact ends at an edge: a flat end or the wall of a profile
    const bool flat = a == this->Tool->largestContactRadius();
    const double rim = this->Tool->surfaceDisplacement(a, depth, 0.3).normal;
    const double outside = this->Tool->surfaceDisplacement(a * (1.0 + 1e-10), depth, 0.3).normal;
    // Just beyond a rim u_z falls as √(r/a-1) = 1e-5 under a flat end (with asin: times √2·2/π =
    // 0.9). Under a smooth tool u_z falls as r-a, with a slope of at most 10 here, thus by 1e-10 a.
    EXPECT_NEAR(outside, rim, flat ? 1e-5 * depth : 1e-8 * depth) << depth;
    EXPECT_LE(outside, rim + 1e-13);
  }
}

TEST_P(HalfSpaceInvariants, NormalDisplacementFarAwayIsThatOfAPointForce)
{
  const double depth = 0.5;
  const double a = this->Tool->contactRadius(depth);
  const double force = this->Tool->force(depth, 1.0);
  for (const double distance : { 1e3, 1e5, 1e8, 1e12, 1e60, 1e120, 1e180 })
  {
    const double r = distance * a;
    // Boussinesq: F/(πE* r). The relative difference is at most <ρ²>/4r² <= (a/r)²/6; the
    // quadrature has an error of 1e-13.
    const double tolerance = 1.0 / (6.0 * distance * distance) + 1e-12;
    EXPECT_TRUE(
      agrees(this->Tool->surfaceDisplacement(r, depth, 0.3).normal, force / (Pi * r), tolerance))
      << distance;
  }
}

TEST_P(HalfSpaceInvariants, RadialDisplacementOutsideIsThatOfAPointForce)
{
  const double depth = 0.5;
  const double a = this->Tool->contactRadius(depth);
  for (const double distance : { 1.0, 1.5, 1e3, 1e12 })
  {
    const double r = distance * a;
    // -(1-2ν)/(2π(1-ν)E*) F/r at ν = 0.25 is -F/(3πE* r), exact up to a few roundings.
    EXPECT_TRUE(agrees(this->Tool->surfaceDisplacement(r, depth, 0.25).radial,
      -this->Tool->force(depth, 1.0) / (3.0 * Pi * r), 1e-14))
      << distance;
  }
}

TEST_P(HalfSpaceInvariants, NoRadialDisplacementWhenIncompressible)
{
  const double a = this->Tool->contactRadius(0.5);
  for (const double r : { 0.0, 0.1 * a, 0.99 * a, a, 3.0 * a })
  {
    EXPECT_EQ(this->Tool->surfaceDisplacement(r, 0.5, 0.5).radial, 0.0) << r;
    if (r > 0.0)
    {
      EXPECT_LT(this->Tool->surfaceDisplacement(r, 0.5, 0.49).radial, 0.0) << r;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Tools, HalfSpaceInvariants,
  ::testing::Values("flat:1.6", "paraboloid:6.35", "paraboloid:1.6", "sphere:6.35", "sphere:1.6",
    "cone:60", "cone:30", "truncated:1,60", "blunted:1,60", "rounded:1.2,0.4", "power:1.5,0.1",
    "power:4,0.01", "profile:0,0;1,0.25;2,1;4,4", "profile:0,0;1,0;3,1"));
