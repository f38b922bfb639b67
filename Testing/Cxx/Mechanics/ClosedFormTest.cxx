// SPDX-License-Identifier: BSD-3-Clause
// The closed forms keep their accuracy very near the axis and very far from it, where the textbook
// formulas suffer from cancellation. Reference: the textbook formulas in long double, and series
// where the cancellation is too large for long double.
#include "Agreement.h"
#include "Quadrature.h"
#include "TestTools.h"

using palpate::Pi;
using palpate::testing::agrees;
using palpate::testing::tool;

namespace
{
using Real = long double;

/// F(r)/F over q = (r/a)², by the reference sheet; for small q by a series.
Real flatShare(Real q)
{
  return q < 1e-6L ? q / 2 + q * q / 8 + q * q * q / 16 : 1 - std::sqrt(1 - q);
}
Real paraboloidShare(Real q)
{
  return q < 1e-6L ? 1.5L * q - 0.375L * q * q - q * q * q / 16 : 1 - (1 - q) * std::sqrt(1 - q);
}
Real coneShare(Real q)
{
  const Real log = std::log((1 + std::sqrt(1 - q)) / std::sqrt(q));
  return q * log + (q < 1e-6L ? q / 2 + q * q / 8 + q * q * q / 16 : 1 - std::sqrt(1 - q));
}

/// u_z outside the contact, with x = a/r, by the reference sheet.
Real flatOutside(Real x)
{
  return 2 * std::asin(x) / static_cast<Real>(Pi);
}
/// u_z outside the contact, times R/a².
Real paraboloidOutside(Real x)
{
  return ((2 - 1 / (x * x)) * std::asin(x) + std::sqrt(1 - x * x) / x) / static_cast<Real>(Pi);
}
/// u_z outside the contact, divided by c a.
Real coneOutside(Real x)
{
  return std::asin(x) + (std::sqrt(1 - x * x) - 1) / x;
}

void compareLoad(const char* name, Real (*share)(Real))
{
  const auto t = tool(name);
  const double depth = 0.5;
  const double a = t->contactRadius(depth);
  for (const double ratio : { 1e-150, 1e-80, 1e-12, 1e-6, 1e-3, 0.05, 0.4, 0.9, 0.9999 })
  {
    const double load =
      -t->surfaceDisplacement(ratio * a, depth, 0.0).radial * 2.0 * Pi * ratio * a;
    const Real q = static_cast<Real>(ratio) * ratio;
    const auto expected = static_cast<double>(static_cast<Real>(t->force(depth, 1.0)) * share(q));
    // The reference has an error of 1e-19/q with q > 1e-6. Near the rim r is rounded, which adds
    // 1e-16/(1-r/a).
    EXPECT_TRUE(agrees(load, expected, 2e-12)) << name << " at " << ratio;
  }
}

void compareOutside(const char* name, Real (*form)(Real), double unit)
{
  const auto t = tool(name);
  const double depth = 0.5;
  const double a = t->contactRadius(depth);
  for (const double ratio : { 1.0001, 1.1, 2.0, 5.0, 19.0, 19.9, 20.0, 20.1, 21.0, 100.0, 1000.0 })
  {
    const double normal = t->surfaceDisplacement(ratio * a, depth, 0.3).normal;
    const auto expected = static_cast<double>(unit * form(1 / static_cast<Real>(ratio)));
    // In long double the paraboloid loses a factor of (r/a)² = 1e6 by cancellation: 1e-13. Near the
    // rim the rounding of r adds 1e-16/(r/a-1). Below 20 a the library's own closed form loses a
    // factor of (r/a)² = 400.
    EXPECT_TRUE(agrees(normal, expected, 5e-13)) << name << " at " << ratio;
  }
}
} // namespace

TEST(ClosedForm, LoadInsideNearTheAxis)
{
  compareLoad("flat:1.6", flatShare);
  compareLoad("paraboloid:6.35", paraboloidShare);
  compareLoad("cone:60", coneShare);
}

TEST(ClosedForm, NormalDisplacementOutside)
{
  const double c = 1.0 / std::tan(Pi / 3.0);
  compareOutside("flat:1.6", flatOutside, 0.5);
  compareOutside("paraboloid:6.35", paraboloidOutside, 0.5); // a²/R = δ
  compareOutside("cone:60", coneOutside, c * tool("cone:60")->contactRadius(0.5));
}

TEST(ClosedForm, FarFieldToSecondOrder)
{
  // u_z = F/(πE* r) [1 + <ρ²>/4r² + …], where <ρ²> is the mean square radius of the load: 2a²/3
  // under a flat end, 2a²/5 under a paraboloid, a²/3 under a cone.
  const auto compare = [](const char* name, double meanSquare)
  {
    const auto t = tool(name);
    const double a = t->contactRadius(0.5);
    for (const double ratio : { 300.0, 1e3, 1e4, 1e7 })
    {
      const double r = ratio * a;
      const double scaled =
        t->surfaceDisplacement(r, 0.5, 0.3).normal * Pi * r / t->force(0.5, 1.0);
      // The next term is below (a/r)⁴. Rounding adds 1e-15.
      EXPECT_NEAR(scaled, 1.0 + 0.25 * meanSquare / (ratio * ratio), std::pow(ratio, -4.0) + 2e-15)
        << name << " at " << ratio;
    }
  };
  compare("flat:1.6", 2.0 / 3.0);
  compare("paraboloid:6.35", 2.0 / 5.0);
  compare("cone:60", 1.0 / 3.0);
}

TEST(ClosedForm, PressureOfTheReferenceSheet)
{
  const double depth = 0.5;
  for (const double share : { 1e-12, 1e-3, 0.5, 0.9, 0.999999 })
  {
    const Real s = share;
    const auto root = static_cast<double>(std::sqrt(1 - s * s));
    // r = share·a is rounded: a relative error of 1e-16/(1-r/a), which is 1e-10 at the last radius.
    const double tolerance = 1e-15 + 3e-16 / (1.0 - share);
    EXPECT_TRUE(agrees(
      tool("flat:1.6")->pressure(share * 1.6, depth, 1.0), depth / (Pi * 1.6 * root), tolerance));
    const double a = std::sqrt(6.35 * depth);
    EXPECT_TRUE(agrees(tool("paraboloid:6.35")->pressure(share * a, depth, 1.0),
      2.0 * a * root / (Pi * 6.35), tolerance));
    const double c = 1.0 / std::tan(Pi / 3.0);
    EXPECT_TRUE(agrees(tool("cone:60")->pressure(share * 2.0 * depth / (Pi * c), depth, 1.0),
      static_cast<double>(0.5L * c * std::acosh(1 / s)), tolerance));
  }
}
