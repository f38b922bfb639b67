// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PiecewiseChebyshev_h
#define palpate_PiecewiseChebyshev_h

#include "Mechanics/PalpateExport.h"

#include <functional>
#include <vector>

namespace palpate
{
/**
 * A function of one variable on [0, end], kept as Chebyshev series of 16 terms on equal pieces.
 *
 * A function that is analytic within one length of a piece around each piece is kept to about
 * 1e-13 of its size there.
 */
class PALPATE_EXPORT PiecewiseChebyshev
{
public:
  static constexpr int Terms = 16;

  PiecewiseChebyshev() = default;
  PiecewiseChebyshev(double end, int pieces, const std::function<double(double)>& function);

  /// 0 beyond the end, where the functions kept so have decayed.
  double evaluate(double x) const noexcept;

private:
  double PieceLength = 1.0;
  std::vector<double> Coefficients; ///< Terms per piece
};
} // namespace palpate

#endif
