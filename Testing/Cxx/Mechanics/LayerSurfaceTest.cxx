// SPDX-License-Identifier: BSD-3-Clause
// The displacement of the surface of a layer: against the Hankel integrals, and against the moments
// of the displacement, which follow from the transforms at small wave numbers.
#include "Mechanics/Layers/LayerContact.h"
#include "Mechanics/Numerics/GaussLegendre.h"
#include "Mechanics/Layers/LayerSurface.h"

#include "Agreement.h"
#include "Quadrature.h"
#include "TestTools.h"

using palpate::LayerBase;
using palpate::LayerContact;
using palpate::LayerKernel;
using palpate::LayerSurface;
using palpate::Pi;
using palpate::testing::agrees;
using palpate::testing::tool;

namespace
{
std::shared_ptr<const LayerKernel> freshKernel(double nu, LayerBase base)
{
  return std::make_shared<const LayerKernel>(nu, base);
}

/// ∫ f dx from `begin` to `end` in panels of 48 nodes.
template <class Function>
double integrate(double begin, double end, int panels, Function&& f)
{
  const palpate::GaussLegendre rule(48);
  double sum = 0.0;
  for (int i = 0; i < panels; ++i)
  {
    const double width = (end - begin) / panels;
    sum += rule.integrate(begin + i * width, begin + (i + 1) * width, f);
  }
  return sum;
}

/// W and V in their printed form (reference: Hankel transforms of the layer), for moderate ω.
double normalTransform(double w, double nu, LayerBase base)
{
  const double k = 3.0 - 4.0 * nu;
  return base == LayerBase::Slip
    ? (std::cosh(2 * w) - 1) / (std::sinh(2 * w) + 2 * w)
    : (2 * k * std::sinh(2 * w) - 4 * w) / (2 * k * std::cosh(2 * w) + 4 * w * w + 1 + k * k);
}

struct Case
{
  const char* tool;
  double depth;
  double nu;
  LayerBase base;
};

const std::vector<Case> Cases = { { "paraboloid:4", 0.5, 0.5, LayerBase::Bonded },
  { "sphere:6.35", 1.0, 0.3, LayerBase::Bonded }, { "cone:70", 0.4, 0.0, LayerBase::Bonded },
  { "flat:1.6", 0.2, 0.45, LayerBase::Bonded }, { "sphere:3", 0.3, 0.4, LayerBase::Slip } };
constexpr double Thickness = 2.5;
} // namespace

// The integral of u_z over the plane is that of uniaxial compression: ∫u_z dA = F h/M with the
// oedometric modulus M = E(1-ν)/((1+ν)(1-2ν)). An incompressible bonded layer keeps its volume.
TEST(LayerSurface, DisplacedVolume)
{
  for (const Case& given : Cases)
  {
    SCOPED_TRACE(given.tool);
    const auto pressed = tool(given.tool);
    const LayerContact contact(*pressed, freshKernel(given.nu, given.base), Thickness);
    const LayerSurface surface(contact, given.depth);
    const double a = contact.contactRadius(given.depth);
    const auto ring = [&](double r) { return 2.0 * Pi * r * surface.at(r).normal; };
    // Outside the rim u_z behaves as a square root, which r = a + s² makes smooth.
    const double end = std::sqrt(20.0 * Thickness);
    const double volume = integrate(0.0, a, 4, ring) +
      integrate(0.0, end, 40, [&](double s) { return 2.0 * s * ring(a + s * s); });
    const double force = contact.evaluate(given.depth, 1.0).force; // E* = 1 means E = 1-ν²
    const double slope = given.base == LayerBase::Slip
      ? 0.5
      : (1.0 - 2.0 * given.nu) / (2.0 * (1.0 - given.nu) * (1.0 - given.nu)); // W'(0)
    const double expected = 2.0 * force * Thickness * slope;
    // The part beyond 20 thicknesses is e^-14 of the indented volume.
    EXPECT_NEAR(volume, expected, 3e-6 * Pi * a * a * given.depth + 1e-6 * expected);
  }
}

// The expansion of û_r for small k gives ∫u_r r² dr = -(4 h²/E*) (F/2π) v, where V = v ω² + …
TEST(LayerSurface, RadialMoment)
{
  for (const Case& given : Cases)
  {
    if (given.base == LayerBase::Slip)
    {
      continue; // V = -ν/(1-ν)/2 + …, so the moment does not exist
    }
    SCOPED_TRACE(given.tool);
    const auto pressed = tool(given.tool);
    const LayerContact contact(*pressed, freshKernel(given.nu, given.base), Thickness);
    const LayerSurface surface(contact, given.depth);
    const double a = contact.contactRadius(given.depth);
    const double k = 3.0 - 4.0 * given.nu;
    const double v = (k * (1.0 - 2.0 * given.nu) - 1.0) / (8.0 * std::pow(1.0 - given.nu, 3.0));
    const double force = contact.evaluate(given.depth, 1.0).force;
    const double expected = -4.0 * Thickness * Thickness * force / (2.0 * Pi) * v;
    const auto moment = [&](double r) { return r * r * surface.at(r).radial; };
    const double end = std::sqrt(20.0 * Thickness);
    const double measured = integrate(0.0, a, 8, moment) +
      integrate(0.0, end, 40, [&](double s) { return 2.0 * s * moment(a + s * s); });
    // The factor r² increases the contribution from beyond 20 thicknesses by 50.
    EXPECT_NEAR(measured, expected, 1e-4 * std::abs(expected));
  }
}

// A flat punch: y is known at the nodes of the kernel, and its transform is a sum of cosines. The
// difference from the half-space converges as e^(-2kh).
TEST(LayerSurface, HankelIntegral)
{
  for (const double nu : { 0.0, 0.3, 0.5 })
  {
    const double a = 2.0;
    const auto flat = tool("flat:2");
    const auto kernel = freshKernel(nu, LayerBase::Bonded);
    const LayerContact contact(*flat, kernel, Thickness);
    const LayerSurface surface(contact, 1.0);
    const auto y = kernel->solve(a / Thickness).flat;
    const auto& t = LayerKernel::nodes();
    const auto& w = LayerKernel::weights();
    for (const double r : { 2.0001, 2.5, 4.0, 7.0, 15.0 })
    {
      const double layer = integrate(0.0, 20.0 / Thickness, 30,
        [&](double k)
        {
          const double transform = a * (w * y * (k * a * t).cos()).sum();
          return (normalTransform(k * Thickness, nu, LayerBase::Bonded) - 1.0) * transform *
            std::cyl_bessel_j(0.0, k * r);
        });
      const double halfSpace = integrate(0.0, std::asin(a / r), 4,
        [&](double theta) { return LayerKernel::interpolate(y, r * std::sin(theta) / a); });
      EXPECT_NEAR(surface.at(r).normal, 2.0 / Pi * (halfSpace + layer), 1e-9) << nu << " at " << r;
    }
  }
}

TEST(LayerSurface, ThickLayerIsAHalfSpace)
{
  const auto sphere = tool("sphere:5");
  const LayerContact contact(*sphere, freshKernel(0.3, LayerBase::Bonded), 1e5);
  const LayerSurface surface(contact, 0.5);
  for (const double r : { 0.0, 0.3, 1.0, 1.5, 1.6, 2.0, 5.0, 30.0 })
  {
    const auto expected = sphere->surfaceDisplacement(r, 0.5, 0.3);
    const auto found = surface.at(r);
    // The base increases the stiffness by M0 a/(π h) = 1e-5.
    EXPECT_NEAR(found.normal, expected.normal, 2e-5 * 0.5) << r;
    EXPECT_NEAR(found.radial, expected.radial, 2e-5 * 0.5) << r;
  }
}

TEST(LayerSurface, NoContactNoDisplacement)
{
  const auto flat = tool("flat:30");
  const LayerContact contact(*flat, freshKernel(0.3, LayerBase::Bonded), 2.0);
  for (const double depth :
    { 0.0, -1.0, 0.5 }) // at 0.5 the contact radius is 15 thicknesses, too large for the law
  {
    EXPECT_EQ(LayerSurface(contact, depth).at(1.0).normal, 0.0);
    EXPECT_EQ(LayerSurface(contact, depth).at(1.0).radial, 0.0);
  }
  EXPECT_TRUE(std::isnan(LayerSurface(contact, 0.5).at(-1.0).normal));
}
