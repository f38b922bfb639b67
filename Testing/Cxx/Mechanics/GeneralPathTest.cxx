// SPDX-License-Identifier: BSD-3-Clause
// The general code for any profile (g by quadrature of f', the other results by quadrature of g),
// against the closed forms of the nine shapes.
#include "GeneralTool.h"

#include "Agreement.h"
#include "Quadrature.h"
#include "TestTools.h"

using palpate::GeneralTool;
using palpate::Pi;
using palpate::testing::agrees;

namespace
{
double zero(double)
{
  return 0.0;
}

GeneralTool::Shape flat(double a)
{
  return { zero, zero, zero, { a }, a, a };
}

GeneralTool::Shape powerLaw(double n, double B)
{
  return { [=](double r) { return B * std::pow(r, n); },
    [=](double r) { return n * B * std::pow(r, n - 1.0); },
    [=](double r) { return n * (n - 1.0) * B * std::pow(r, n - 2.0); }, {} };
}

/// A sphere up to 0.999 R, so that the slope of the profile stays finite.
GeneralTool::Shape sphere(double R)
{
  return { [=](double r) { return R - std::sqrt(R * R - r * r); },
    [=](double r) { return r / std::sqrt(R * R - r * r); },
    [=](double r) { return R * R / std::pow(R * R - r * r, 1.5); }, {}, 0.0, 0.999 * R };
}

GeneralTool::Shape cone(double degrees)
{
  return powerLaw(1.0, 1.0 / std::tan(degrees * Pi / 180.0));
}

GeneralTool::Shape truncatedCone(double b, double degrees)
{
  const double c = 1.0 / std::tan(degrees * Pi / 180.0);
  return { [=](double r) { return r > b ? c * (r - b) : 0.0; },
    [=](double r) { return r > b ? c : 0.0; }, zero, { b }, b };
}

GeneralTool::Shape bluntedCone(double R, double degrees)
{
  const double c = 1.0 / std::tan(degrees * Pi / 180.0);
  const double b = R * std::cos(degrees * Pi / 180.0);
  const auto tip = sphere(R);
  return { [=](double r) { return r > b ? tip.profile(b) + c * (r - b) : tip.profile(r); },
    [=](double r) { return r > b ? c : tip.slope(r); },
    [=](double r) { return r > b ? 0.0 : tip.curvature(r); }, { b } };
}

GeneralTool::Shape roundedFlat(double b, double edge)
{
  return { [=](double r) { return r > b ? (r - b) * (r - b) / (2.0 * edge) : 0.0; },
    [=](double r) { return r > b ? (r - b) / edge : 0.0; },
    [=](double r) { return r > b ? 1.0 / edge : 0.0; }, { b }, b };
}

/// Corners at 0, 1 and 2, and a wall at 4, as in "profile:0,0;1,0.25;2,1;4,4".
GeneralTool::Shape corners()
{
  return { [](double r) { return r < 1.0 ? 0.25 * r
                            : r < 2.0    ? 0.75 * r - 0.5
                                         : 1.5 * r - 2.0; },
    [](double r) { return r < 1.0 ? 0.25
                     : r < 2.0    ? 0.75
                                  : 1.5; }, zero, { 1.0, 2.0 }, 0.0, 4.0 };
}

struct Case
{
  const char* name;
  GeneralTool::Shape shape;
  std::vector<double> depths;
};

std::vector<Case> cases()
{
  // Depths on both sides of every kink. The last depth of the profile puts its wall in contact.
  return { { "flat:1.6", flat(1.6), { 1e-3, 0.2, 1.5 } },
    { "paraboloid:6.35", powerLaw(2.0, 0.5 / 6.35), { 1e-3, 0.2, 1.5 } },
    { "sphere:1.6", sphere(1.6), { 1e-3, 0.2, 1.5 } },
    { "cone:60", cone(60.0), { 1e-3, 0.2, 1.5 } }, { "cone:20", cone(20.0), { 1e-3, 0.2, 1.5 } },
    { "truncated:1,60", truncatedCone(1.0, 60.0), { 1e-3, 0.2, 1.5 } },
    { "blunted:1,60", bluntedCone(1.0, 60.0), { 1e-3, 0.2, 0.3, 1.5 } },
    // a tip that is much wider than the contact, where the closed form suffers from cancellation
    { "blunted:50,89.5", bluntedCone(50.0, 89.5), { 1e-4, 1e-3, 1e-2 } },
    { "power:1.1,0.2", powerLaw(1.1, 0.2), { 1e-3, 1.5 } },
    { "rounded:1.2,0.4", roundedFlat(1.2, 0.4), { 1e-3, 0.2, 1.5 } },
    { "power:1.5,0.1", powerLaw(1.5, 0.1), { 1e-3, 0.2, 1.5 } },
    { "power:4,0.01", powerLaw(4.0, 0.01), { 1e-3, 0.2, 1.5 } },
    { "profile:0,0;1,0.25;2,1;4,4", corners(), { 1e-3, 0.2, 0.5, 1.5, 20.0 } } };
}

class GeneralPath : public ::testing::TestWithParam<int>
{
protected:
  Case Given = cases()[static_cast<std::size_t>(this->GetParam())];
  GeneralTool General{ this->Given.shape };
  std::unique_ptr<palpate::AxisymmetricTool> Closed = palpate::testing::tool(this->Given.name);
};
} // namespace

TEST_P(GeneralPath, ReducedProfile)
{
  EXPECT_EQ(this->General.kinks().size(), this->Closed->kinks().size());
  for (const double share : { 1e-9, 1e-3, 0.3, 0.9, 0.99999 })
  {
    const double x = share * std::min(this->Closed->largestContactRadius(), 5.0);
    // 1e-10 is required of the closed forms. The quadrature of f' is accurate to 1e-13. For the
    // sphere its accuracy falls to 3e-7 at 0.99999 R (beyond the outer radius here), because the
    // slope is singular at R.
    if (x < this->General.largestContactRadius())
    {
      EXPECT_TRUE(agrees(this->General.reducedProfile(x), this->Closed->reducedProfile(x), 1e-10))
        << x;
    }
  }
}

TEST_P(GeneralPath, ForceAndContactRadius)
{
  for (const double depth : this->Given.depths)
  {
    const auto general = this->General.evaluate(depth, 3.45);
    const auto closed = this->Closed->evaluate(depth, 3.45);
    EXPECT_TRUE(agrees(general.contactRadius, closed.contactRadius, 1e-10)) << depth;
    EXPECT_TRUE(agrees(general.force, closed.force, 1e-10)) << depth;
    EXPECT_TRUE(agrees(general.stiffness, closed.stiffness, 1e-10)) << depth;
  }
}

TEST_P(GeneralPath, PressureAndDisplacement)
{
  for (const double depth : this->Given.depths)
  {
    SCOPED_TRACE(depth);
    const double a = this->Closed->contactRadius(depth);
    std::vector<double> radii;
    for (const double share : { 1e-6, 1e-3, 0.05, 0.3, 0.5, 0.9, 0.999, 1.001, 1.5, 7.0, 1e3 })
    {
      radii.push_back(share * a);
    }
    for (const double kink : this->Closed->kinks())
    {
      if (kink < a)
      {
        for (const double aside : { -1e-6, 1e-6, -1e-3, 1e-3 })
        {
          radii.push_back(kink * (1.0 + aside));
        }
      }
    }
    for (const double r : radii)
    {
      // 1e-8 is required of the quadrature. The sums of f' and f'' in g' lose about 1e-16 divided
      // by the distance from a kink, 1e-6, twice. The radii differ by as much.
      const double pressure = this->Closed->pressure(r, depth, 1.0);
      EXPECT_TRUE(agrees(this->General.pressure(r, depth, 1.0), pressure, 1e-8)) << r / a;
      const auto u = this->Closed->surfaceDisplacement(r, depth, 0.2);
      const auto v = this->General.surfaceDisplacement(r, depth, 0.2);
      EXPECT_TRUE(agrees(v.radial, u.radial, 1e-8)) << r / a;
      EXPECT_TRUE(agrees(v.normal, u.normal, 1e-8)) << r / a;
    }
  }
}

TEST_P(GeneralPath, DepthsOfStrainAndRadius)
{
  // General tools measure strain by δ/a, so only tools with the same measure are compared.
  const std::string name = this->Given.name;
  if (name.substr(0, 4) != "cone" && name.substr(0, 5) != "parab" &&
    name.substr(0, 6) != "sphere" && name.substr(0, 7) != "blunted" &&
    name.substr(0, 7) != "profile")
  {
    EXPECT_TRUE(agrees(this->General.depthAtStrain(0.3), this->Closed->depthAtStrain(0.3), 1e-9));
  }
  EXPECT_TRUE(agrees(
    this->General.depthAtContactRadius(1.5), this->Closed->depthAtContactRadius(1.5), 1e-10));
}

INSTANTIATE_TEST_SUITE_P(
  Shapes, GeneralPath, ::testing::Range(0, static_cast<int>(cases().size())));

TEST(GeneralPathSphere, UpToItsShoulders)
{
  // Pressure and displacements of the sphere use the general code. They are compared with the
  // tests' own rule of 400 points on g = x artanh(x/R), with a different substitution (x = r +
  // (a-r) u², x = a sin θ).
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
      // a is computed back from δ with an error of 1e-16/(1-a/R) = 1e-14. The library guarantees
      // 1e-11 up to 0.99 R.
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
