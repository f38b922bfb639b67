// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_StrainTable_h
#define palpate_StrainTable_h

#include "Mechanics/PalpateExport.h"

#include <array>
#include <cstddef>
#include <vector>

namespace palpate
{
/// The correction factor c = F_finite/F_small at one depth, dc/dδ (1/mm), and the relative error of
/// c.
struct StrainFactor
{
  double factor = 1.0;
  double slope = 0.0;
  double error = 0.0;
};

/// The largest depth of a table for layers of total thickness H: 1/δ_max = 1/endless + 1/(fraction
/// H). This function of H is as smooth as c.
struct StrainReach
{
  double endless;        ///< largest depth on infinitely thick layers, mm; may be infinite
  double fraction = 0.0; ///< fraction of H; 0 if δ_max does not depend on the thickness
  /// Thickness of the layers below the first two, which do not vary, mm; part of H.
  double below = 0.0;

  double at(double thickness, double second) const noexcept
  {
    const double whole = this->fraction * (thickness + second + this->below);
    return whole > 0.0 ? 1.0 / (1.0 / this->endless + 1.0 / whole) : this->endless;
  }
};

/**
 * The factor c of one tool as a function of Poisson's ratio, thickness of the layer (in a stack, of
 * its first two layers) and depth. It is interpolated by cubic polynomials through four nodes (or
 * all nodes, if there are fewer) over ν, ln h and √(δ/δ_max). c is a smooth function of these
 * variables: for a sphere c - 1 is nearly proportional to √δ. The depth 0 is an additional node.
 * There c is 1 or, for a tool without a length (cone), the same as at every depth.
 *
 * Beyond the last root c is extrapolated linearly over a quarter of that root; at larger depths it
 * is constant. If no equilibrium was found at a depth, the row ends before that depth, and c is
 * constant directly from the end of the row. The error increases with the distance from the end.
 */
class PALPATE_EXPORT StrainTable
{
public:
  /// The nodes of each variable, in ascending order. `thicknesses` is empty for a half-space.
  struct Axes
  {
    std::vector<double> ratios;      ///< Poisson's ratios
    std::vector<double> thicknesses; ///< mm
    std::vector<double> roots;       ///< √(δ/δ_max), 0 < root <= 1; at most MostRoots
    /// Thicknesses of a stack's second layer, mm; empty if there is no second layer.
    std::vector<double> seconds = {};
  };

  /// `factors` are ordered by ratio, then thickness, then second thickness, then root. An unknown
  /// factor is 0; all following factors of its row must then also be 0. `constant` means that c
  /// does not depend on depth. `error` is the relative error at the nodes.
  StrainTable(
    Axes axes, std::vector<double> factors, const StrainReach& reach, bool constant, double error);

  static constexpr std::size_t MostRoots = 16;

  /// c as a function of the depth only, for one body.
  class Course
  {
  public:
    StrainFactor at(double depth) const;

  private:
    friend class StrainTable;
    const StrainTable* Table = nullptr;
    double Deepest = 1.0; ///< depth at which the table ends for this body, mm
    double Known = 1.0;   ///< last root with a known factor
    std::array<double, MostRoots + 1> Factors{}; ///< c at depth 0 and at the roots
  };

  /// These functions do not allocate. Creating a Course takes 0.2 µs, and evaluating it at one
  /// depth 30 ns.
  Course course(double poissonRatio, double thickness, double second = 0.0) const;
  StrainFactor at(double depth, double poissonRatio, double thickness, double second = 0.0) const
  {
    return this->course(poissonRatio, thickness, second).at(depth);
  }

  const Axes& axes() const noexcept { return this->Given; }
  const std::vector<double>& factors() const noexcept { return this->Factors; }

private:
  Axes Given;
  std::vector<double> Factors;
  std::vector<double> Known; ///< last root of each row with a known factor
  StrainReach Reach;
  bool ThickestEnds = false; ///< whether at least one row of the thickest layer ends early
  bool Constant;
  double Error;
};
} // namespace palpate

#endif
