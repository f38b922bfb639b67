// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_QuadraticLine_h
#define palpate_QuadraticLine_h

#include <array>

/// The line element with three nodes on [-1, 1]. The elements of a FiniteBody are products of two
/// such elements.
namespace palpate::QuadraticLine
{
/// The Gauss rule with three points on [-1, 1].
inline constexpr int GaussCount = 3;
inline constexpr std::array<double, 3> GaussNode = { -0.774596669241483377, 0.0,
  0.774596669241483377 };
inline constexpr std::array<double, 3> GaussWeight = { 5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0 };

/// The three quadratic shape functions on [-1, 1] and their slopes.
inline std::array<double, 3> shapes(double x)
{
  return { 0.5 * x * (x - 1.0), 1.0 - x * x, 0.5 * x * (x + 1.0) };
}
inline std::array<double, 3> slopes(double x)
{
  return { x - 0.5, -2.0 * x, x + 0.5 };
}
} // namespace palpate::QuadraticLine

#endif
