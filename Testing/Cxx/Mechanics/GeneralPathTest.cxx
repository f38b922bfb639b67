// SPDX-License-Identifier: BSD-3-Clause
// The path every profile can take (quadrature over g and g') against closed forms.
#include "AxisymmetricTool.h"

#include "Agreement.h"
#include "Quadrature.h"
#include "TestTools.h"

#include <functional>

using palpate::testing::agrees;
using palpate::testing::Pi;

namespace
{
using Function = std::function<double(double)>;

/// A tool known only by f, g, g', a(δ) and F(δ)/E*: everything else is the library's default.
class GeneralTool final : public palpate::AxisymmetricTool
{
public:
  struct Shape
  {
    Function f, g, slope, radius, force;
  };
  explicit GeneralTool(Shape shape)
    : Given(std::move(shape))
  {
  }
  std::string specification() const override { return "general"; }
  double profile(double r) const override { return this->Given.f(r); }
  double forceExponent() const override { return 1.0; }
  double depthAtStrain(double) const override { return 0.0; }
  double depthAtContactRadius(double a) const override { return this->Given.g(a); }

  double reducedProfile(double x) const override { return this->Given.g(x); }
  double largestContactRadius() const override { return std::numeric_limits<double>::infinity(); }

protected:
  double radiusAt(double depth) const override { return this->Given.radius(depth); }
  double forcePerModulus(double, double depth) const override { return this->Given.force(depth); }
  double reducedSlope(double x) const override { return this->Given.slope(x); }

private:
  Shape Given;
};

GeneralTool generalFlat(double a)
{
  const auto zero = [](double) { return 0.0; };
  return GeneralTool(
    { zero, zero, zero, [a](double) { return a; }, [a](double depth) { return 2.0 * a * depth; } });
}

GeneralTool generalParaboloid(double R)
{
  return GeneralTool(
    { [R](double r) { return 0.5 * r * r / R; }, [R](double x) { return x * x / R; },
      [R](double x) { return 2.0 * x / R; }, [R](double depth) { return std::sqrt(R * depth); },
      [R](double depth) { return 4.0 / 3.0 * std::sqrt(R) * std::pow(depth, 1.5); } });
}

GeneralTool generalCone(double degrees)
{
  const double c = 1.0 / std::tan(degrees * Pi / 180.0);
  return GeneralTool({ [c](double r) { return c * r; }, [c](double x) { return 0.5 * Pi * c * x; },
    [c](double) { return 0.5 * Pi * c; }, [c](double depth) { return 2.0 * depth / (Pi * c); },
    [c](double depth) { return 2.0 * depth * depth / (Pi * c); } });
}

/// `lowest`: r/a from which the pressure is compared.
void compare(const palpate::AxisymmetricTool& general, const std::string& name, double lowest)
{
  SCOPED_TRACE(name);
  const auto closed = palpate::testing::tool(name);
  for (const double depth : { 1e-3, 0.2, 1.5 })
  {
    const double a = closed->contactRadius(depth);
    for (const double share : { 1e-6, 1e-3, 0.05, 0.3, 0.5, 0.9, 0.999, 1.001, 1.5, 7.0, 1e3 })
    {
      const double r = share * a;
      if (share >= lowest)
      {
        // 1e-9: what 64 points give on the worst of these integrands, with a margin of 100.
        const double pressure = closed->pressure(r, depth, 1.0);
        EXPECT_TRUE(agrees(general.pressure(r, depth, 1.0), pressure, 1e-9)) << share;
      }
      const auto u = closed->surfaceDisplacement(r, depth, 0.2);
      const auto v = general.surfaceDisplacement(r, depth, 0.2);
      EXPECT_TRUE(agrees(v.radial, u.radial, 1e-9)) << share;
      EXPECT_TRUE(agrees(v.normal, u.normal, 1e-9)) << share;
    }
  }
}
} // namespace

TEST(GeneralPath, Flat)
{
  compare(generalFlat(1.6), "flat:1.6", 0.0);
}

TEST(GeneralPath, Paraboloid)
{
  compare(generalParaboloid(6.35), "paraboloid:6.35", 0.0);
  compare(generalParaboloid(0.3), "paraboloid:0.3", 0.0);
}

TEST(GeneralPath, Cone)
{
  // Under an apex g'(0) > 0 makes the pressure logarithmic, which no Gauss rule follows to r → 0:
  // 64 points reach 1e-9 from r = 0.05 a on. (ConeTool has the closed form.)
  compare(generalCone(60.0), "cone:60", 0.05);
  compare(generalCone(20.0), "cone:20", 0.05);
}

TEST(GeneralPath, TheExactSphereUpToItsShoulders)
{
  // Pressure and displacements of the sphere have no override: compare with the tests' own rule of
  // 400 points on g = x artanh(x/R), substituted differently (x = r + (a-r) u², x = a sin θ).
  const double R = 1.6;
  const palpate::testing::Quadrature rule(400);
  const auto sphere = palpate::testing::tool("sphere:1.6");
  for (const double ratio : { 0.1, 0.5, 0.9, 0.99 })
  {
    const double a = ratio * R;
    const double depth = a * std::atanh(ratio);
    const auto g = [&](double x) { return x * std::atanh(x / R); };
    const auto slope = [&](double x) { return std::atanh(x / R) + x * R / ((R - x) * (R + x)); };
    for (const double share : { 0.1, 0.5, 0.95 })
    {
      const double r = share * a;
      const double pressure = rule.integrate(0.0, std::sqrt(a - r),
                                [&](double u)
                                {
                                  const double x = r + u * u;
                                  return slope(x) * 2.0 / std::sqrt(x + r);
                                }) /
        Pi;
      // a comes back from δ with 1e-16/(1-a/R) = 1e-14; the library promises 1e-11 up to 0.99 R.
      EXPECT_TRUE(agrees(sphere->pressure(r, depth, 1.0), pressure, 1e-10)) << ratio;
    }
    for (const double share : { 1.05, 2.0, 30.0 })
    {
      const double r = share * a;
      const double lift = rule.integrate(0.0, 1.0,
        [&](double u)
        {
          const double x = a * (1.0 - u * u);
          return g(x) / std::sqrt((r - x) * (r + x)) * 2.0 * a * u;
        });
      const double normal = 2.0 / Pi * (depth * std::asin(a / r) - lift);
      EXPECT_TRUE(agrees(sphere->surfaceDisplacement(r, depth, 0.3).normal, normal, 1e-10))
        << ratio;
    }
  }
}
