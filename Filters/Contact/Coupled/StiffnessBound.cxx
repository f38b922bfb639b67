// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/Coupled/StiffnessBound.h"

#include "Mechanics/Numerics/Constants.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
/// Inverts a positive definite matrix in place (Gauss-Jordan). Returns false if the matrix is not
/// positive definite.
bool invert(double* matrix, std::size_t rows) noexcept
{
  const auto at = [matrix, rows](std::size_t i, std::size_t j) -> double&
  { return matrix[i * rows + j]; };
  for (std::size_t p = 0; p < rows; ++p)
  {
    const double pivot = at(p, p);
    if (!(pivot > 0.0))
    {
      return false;
    }
    at(p, p) = 1.0;
    for (std::size_t j = 0; j < rows; ++j)
    {
      at(p, j) /= pivot;
    }
    for (std::size_t i = 0; i < rows; ++i)
    {
      const double factor = at(i, p);
      if (i == p || factor == 0.0)
      {
        continue;
      }
      at(i, p) = 0.0;
      for (std::size_t j = 0; j < rows; ++j)
      {
        at(i, j) -= factor * at(p, j);
      }
    }
  }
  return true;
}

/// Returns an upper bound of the largest eigenvalue of a symmetric matrix: the eighth root of the
/// largest row sum of the eighth power of the matrix. The bound is too large by a factor of at most
/// rows^(1/16). Overwrites both arrays.
double largestEigenvalue(double* matrix, double* power, std::size_t rows) noexcept
{
  constexpr int squarings = 3;
  for (int k = 0; k < squarings; ++k)
  {
    for (std::size_t i = 0; i < rows; ++i)
    {
      for (std::size_t j = 0; j < rows; ++j)
      {
        double sum = 0.0;
        for (std::size_t l = 0; l < rows; ++l)
        {
          sum += matrix[i * rows + l] * matrix[j * rows + l];
        }
        power[i * rows + j] = sum;
      }
    }
    std::swap(matrix, power);
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < rows; ++i)
  {
    double sum = 0.0;
    for (std::size_t j = 0; j < rows; ++j)
    {
      sum += std::abs(matrix[i * rows + j]);
    }
    largest = std::max(largest, sum);
  }
  return std::sqrt(std::sqrt(std::sqrt(largest)));
}
} // namespace

double stiffnessBound(double* compliance, double* spare, std::size_t rows) noexcept
{
  return invert(compliance, rows) ? largestEigenvalue(compliance, spare, rows) : Infinity;
}
} // namespace palpate
