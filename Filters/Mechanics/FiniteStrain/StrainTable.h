// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_StrainTable_h
#define palpate_StrainTable_h

#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// A correction at one depth: c = F_finite/F_small; dc/dδ (1/mm); its own relative error.
struct StrainFactor
{
  double factor = 1.0;
  double slope = 0.0;
  double error = 0.0;
};

/**
 * c of one tool over Poisson's ratio, thickness of the layer and depth: cubic polynomials through
 * four nodes (or as many as there are) over ν, ln h and √(δ/δ_max), where c is smooth: on a sphere
 * c - 1 is nearly in proportion to √δ. At δ = 0, which is a node of its own, c is 1, or, of a tool
 * without a length (cone), what it is at every depth.
 *
 * Rows may end early, where no equilibrium was found: beyond, the factor stays at its last and the
 * error grows by the distance from there.
 */
class PALPATE_EXPORT StrainTable
{
public:
  /// What lies where; thicknesses empty for a half-space. All ascend.
  struct Axes
  {
    std::vector<double> ratios;      ///< Poisson's
    std::vector<double> thicknesses; ///< mm
    std::vector<double> roots;       ///< √(δ/δ_max), 0 < root <= 1
  };

  /// `factors`: by ratio, then thickness, then root; 0 where unknown, then unknown to the row's
  /// end. `deepest` (mm): δ_max, one for each thickness, or one. `constant`: c does not depend on
  /// depth. `error`: of the nodes themselves.
  StrainTable(Axes axes, std::vector<double> factors, std::vector<double> deepest, bool constant,
    double error);

  /// Does not allocate.
  StrainFactor at(double depth, double poissonsRatio, double thickness) const;

  const Axes& axes() const noexcept { return this->Given; }
  const std::vector<double>& factors() const noexcept { return this->Factors; }

private:
  double deepestAt(double thickness) const;

  Axes Given;
  std::vector<double> Factors;
  std::vector<double> Known; ///< the last known root of each row
  std::vector<double> Deepest;
  bool Constant;
  double Error;
};
} // namespace palpate

#endif
