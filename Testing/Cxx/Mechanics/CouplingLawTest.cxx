// SPDX-License-Identifier: BSD-3-Clause
// Deflection of a layer at a distance from a force, against direct integration of its Hankel
// transform.
#include "Mechanics/Coupling/CouplingLaw.h"
#include "Mechanics/Layers/LayerStack.h"
#include "Mechanics/Numerics/Constants.h"

#include "ReferenceTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using palpate::CouplingLaw;
using palpate::LayerBase;
using palpate::LayerKernel;
using palpate::Pi;
using palpate::testing::ReferenceTable;

namespace
{
/// W - 1 of a layer as in LayerKernel.h. Numerator and denominator are divided by e^(2ω).
double transform(double w, double nu, LayerBase base)
{
  const double e2 = std::exp(-2.0 * w);
  const double e4 = e2 * e2;
  if (base == LayerBase::Slip)
  {
    return (0.5 * (1.0 + e4) - e2) / (0.5 * (1.0 - e4) + 2.0 * w * e2) - 1.0;
  }
  const double k = 3.0 - 4.0 * nu;
  return (k * (1.0 - e4) - 4.0 * w * e2) / (k * (1.0 + e4) + (4.0 * w * w + 1.0 + k * k) * e2) -
    1.0;
}

/// 1 + x ∫ (W - 1) J₀(ωx) dω by Simpson's rule, with an error of 1e-8 for x up to 6.
double byQuadrature(double x, double nu, LayerBase base)
{
  constexpr int steps = 8000;
  constexpr double end = 25.0; // the integrand has fallen to e^-50
  double sum = 0.0;
  for (int i = 0; i <= steps; ++i)
  {
    const double w = end * i / steps;
    const double weight = i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    const double at = i == 0 && base == LayerBase::Slip ? -1.0 : transform(w, nu, base);
    sum += weight * at * std::cyl_bessel_j(0.0, w * x);
  }
  return 1.0 + x * sum * end / steps / 3.0;
}
} // namespace

TEST(CouplingLaw, IsTheHankelTransformOfTheLayer)
{
  const struct
  {
    double nu;
    LayerBase base;
  } cases[] = { { 0.3, LayerBase::Bonded }, { 0.5, LayerBase::Bonded }, { 0.3, LayerBase::Slip } };
  for (const auto& [nu, base] : cases)
  {
    const CouplingLaw law(LayerKernel(nu, base));
    for (const double x : { 0.0, 0.03, 0.2, 0.77, 1.0, 1.6, 2.5, 4.1, 6.0 })
    {
      // 2e-6: error of the polynomials between the knots.
      EXPECT_NEAR(law.at(x).value, byQuadrature(x, nu, base), 2e-6) << nu << " " << x;
      const double step = 1e-3;
      const double slope = x == 0.0
        ? (byQuadrature(step, nu, base) - 1.0) / step
        : (byQuadrature(x + step, nu, base) - byQuadrature(x - step, nu, base)) / (2.0 * step);
      // Central differences have an error of step² g'''/6, one-sided differences of step g''/2.
      EXPECT_NEAR(law.at(x).slope, slope, x == 0.0 ? 1e-3 : 5e-5) << nu << " " << x;
    }
  }
}

// Two flat ends with a radius of half the thickness: boundary elements give g = 0.14, -0.08 and
// -0.05 at a distance of 2, 3 and 5 radii. With the law of a point force, the forces of the two
// ends at equal depth have errors of 6 to 14 %, 1.8 % and 0.3 %.
TEST(CouplingLaw, BulgesBeyondOneThickness)
{
  const CouplingLaw law(LayerKernel(0.45, LayerBase::Bonded));
  // force on the layer / force on the half-space: layer_bonded_flat_kappa.csv
  const double factor = 1.80625993706;
  const struct
  {
    double radii, share, least, most;
  } cases[] = { { 2.0, 0.14, 0.06, 0.14 }, { 3.0, -0.08, 0.0, 0.018 }, { 5.0, -0.05, 0.0, 0.003 } };
  for (const auto& [radii, share, least, most] : cases)
  {
    const auto force = [&, apart = radii](double g)
    { return 1.0 / (1.0 + 2.0 * factor * g / (Pi * apart)); };
    const double error = std::abs(force(law.at(0.5 * radii).value) / force(share) - 1.0);
    EXPECT_GE(error, least) << radii;
    EXPECT_LE(error, most) << radii;
  }
  EXPECT_NEAR(law.at(100.0).value, 0.0, 1e-6); // decays as e^-x or faster
}

TEST(CouplingLaw, OfAHalfSpaceIsBoussinesq)
{
  const CouplingLaw law;
  EXPECT_EQ(law.at(0.1).value, 1.0);
  EXPECT_EQ(law.at(50.0).slope, 0.0);
  EXPECT_DOUBLE_EQ(law.contactRadius(12.0, 3.0, 0.0), 2.0);
}

// A layer on a half-space of the same material is a half-space.
TEST(CouplingLaw, OfALayerOnItsLikeIsBoussinesq)
{
  palpate::LayerStack stack;
  stack.layers = { { 2.0, 0.1, 0.4 } };
  stack.hasHalfSpace = true;
  stack.halfSpace = { 1.0, 0.1, 0.4 };
  const CouplingLaw law{ LayerKernel(stack) };
  for (const double x : { 0.0, 0.5, 2.0, 10.0, 38.0 })
  {
    EXPECT_NEAR(law.at(x).value, 1.0, 1e-6) << x;
  }
}

TEST(CouplingLaw, TellsTheRadiusOfAStiffness)
{
  const ReferenceTable table("layer_bonded_flat_kappa.csv");
  int compared = 0;
  for (const char* nu : { "0.3", "0.5" })
  {
    const CouplingLaw law(LayerKernel(std::stod(nu), LayerBase::Bonded));
    std::size_t row = 0;
    while (table.text(row, "nu\\a_over_h") != nu)
    {
      ++row;
    }
    for (const char* ratio : { "0.02", "0.1", "0.3", "0.5", "1.0", "1.5", "2.0" })
    {
      const double thickness = 3.0;
      const double radius = std::stod(ratio) * thickness;
      const double stiffness = 2.0 * 1.7 * radius * table.number(row, ratio);
      // Error of the linear interpolation between the knots: 1 %.
      EXPECT_NEAR(law.contactRadius(stiffness, 1.7, thickness) / radius, 1.0, 0.01)
        << nu << " " << ratio;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 14);
}
