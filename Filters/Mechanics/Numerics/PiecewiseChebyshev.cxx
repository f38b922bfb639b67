// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Numerics/ChebyshevRule.h"
#include "Mechanics/Numerics/Constants.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace palpate
{
PiecewiseChebyshev::PiecewiseChebyshev(
  double end, int pieces, const std::function<double(double)>& function)
  : PieceLength(end / pieces)
{
  std::array<double, Terms> values{};
  for (int piece = 0; piece < pieces; ++piece)
  {
    for (int i = 0; i < Terms; ++i)
    {
      const double t = std::cos(Pi * (i + 0.5) / Terms);
      values[static_cast<std::size_t>(i)] = function(this->PieceLength * (piece + 0.5 * (1.0 + t)));
    }
    for (int k = 0; k < Terms; ++k)
    {
      double sum = 0.0;
      for (int i = 0; i < Terms; ++i)
      {
        sum += values[static_cast<std::size_t>(i)] * std::cos(Pi * k * (i + 0.5) / Terms);
      }
      this->Coefficients.push_back((k == 0 ? 1.0 : 2.0) / Terms * sum);
    }
  }
}

double PiecewiseChebyshev::evaluate(double x) const noexcept
{
  const double position = x / this->PieceLength;
  auto piece = static_cast<std::size_t>(position);
  if ((piece + 1) * Terms > this->Coefficients.size())
  {
    if (piece * Terms > this->Coefficients.size() || static_cast<double>(piece) < position)
    {
      return 0.0;
    }
    --piece; // x is the end of the last piece
  }
  // Clenshaw's recurrence for the Chebyshev series.
  const double t = 2.0 * (position - static_cast<double>(piece)) - 1.0;
  const double* c = this->Coefficients.data() + piece * Terms;
  double b1 = 0.0;
  double b2 = 0.0;
  for (int k = Terms - 1; k > 0; --k)
  {
    const double b0 = 2.0 * t * b1 - b2 + c[k];
    b2 = b1;
    b1 = b0;
  }
  return t * b1 - b2 + c[0];
}
} // namespace palpate
