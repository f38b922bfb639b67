// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Numerics/GaussLegendre.h"

#include "Agreement.h"

#include <cmath>

TEST(GaussLegendre, ExactForPolynomialsUpToDegree2n1)
{
  for (const int n : { 1, 2, 3, 8, 16, 64 })
  {
    const palpate::GaussLegendre rule(n);
    for (int degree = 0; degree <= 2 * n - 1; ++degree)
    {
      const double computed =
        rule.integrate(0.0, 2.0, [&](double x) { return std::pow(0.5 * x, degree); });
      // ∫_0^2 (x/2)^d dx = 2/(d+1). The eigenvalues are accurate to about 1e-15.
      EXPECT_TRUE(palpate::testing::agrees(computed, 2.0 / (degree + 1), 1e-13))
        << n << " nodes, degree " << degree;
    }
  }
}

TEST(GaussLegendre, NotExactBeyond)
{
  // The integral of P_2² = ((3x²-1)/2)² over [-1, 1] is 2/5, but the two nodes are the roots of the
  // Legendre polynomial P_2.
  const palpate::GaussLegendre rule(2);
  const double computed =
    rule.integrate(-1.0, 1.0, [](double x) { return std::pow(1.5 * x * x - 0.5, 2); });
  EXPECT_NEAR(computed, 0.0, 1e-30); // squares of rounding errors
}
