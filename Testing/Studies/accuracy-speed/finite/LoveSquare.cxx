// SPDX-License-Identifier: BSD-3-Clause
#include "LoveSquare.h"

#include <cmath>

namespace palpate::testing
{

double loveSquare(double x, double y)
{
  const double right = std::abs(x) + 0.5; // distances to the sides; the result is even in x and y
  const double left = std::abs(x) - 0.5;
  const double top = std::abs(y) + 0.5;
  const double bottom = std::abs(y) - 0.5;
  // asinh(t/|s|) = ln(t + sqrt(t² + s²)) - ln|s|: the logarithms without cancellation errors.
  const auto term = [](double s, double t) { return s * std::asinh(t / std::abs(s)); };
  return term(right, top) - term(right, bottom) + term(top, right) - term(top, left) -
    term(left, top) + term(left, bottom) - term(bottom, right) + term(bottom, left);
}

} // namespace palpate::testing
