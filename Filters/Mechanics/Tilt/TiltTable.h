// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TiltTable_h
#define palpate_TiltTable_h

#include "Mechanics/PalpateExport.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace palpate
{
/// The deepest point of a tilted tool, from its tip.
struct DeepestPoint
{
  double drop = 0.0;   ///< h, its depth below the tip, mm, >= 0
  double offset = 0.0; ///< x = dh/dθ, its lateral distance from the tip, mm, >= 0
};

/// τ and its derivatives, by the depth D at one tilt and by the tilt θ at one depth.
struct TiltFactor
{
  double value = 1.0;
  double byDepth = 0.0;      ///< 1/mm
  double byDepthTwice = 0.0; ///< 1/mm²
  double byAngle = 0.0;      ///< 1/rad
};

/// Numbers of a TiltTable, as they are stored.
struct TiltTerms
{
  double range = 0.0;   ///< D_m, mm, > 0
  double largest = 0.0; ///< tilt, rad, > 0 and less than a right angle
  /// κ >= 0. A tool with a flat end (κ = 3) touches with its rim: its force depends on the ratio of
  /// depth and drop.
  double dropScale = 0.0;
  int depths = 0; ///< nodes x_i = i/(depths - 1), 2 or more
  int angles = 0; ///< nodes y_j = j/(angles - 1), 2 or more
  int drops = 0;  ///< nodes θ_k = largest k/(drops - 1), 2 or more
  int laws = 0;   ///< 1 to MostLaws

  static constexpr int MostLaws = 16;
  static constexpr int MostNodes = 256; ///< of each kind

  bool areFelt() const noexcept { return this->laws > 0; }
};

/// What is wrong with them, with the number, or "".
PALPATE_EXPORT std::string faultOfTilts(const TiltTerms& terms);

/**
 * The effect of tilting a tool on its force. With W_0(D) the work of pressing it D deep upright,
 * that of the tool tilted by θ, its deepest point D deep, is
 *   W(D, θ) = W_0(D) τ(D, θ),  D = δ + h(θ),
 * δ the depth of its tip, on the axis, and h the drop of its deepest point. Force and torque follow
 * from this one energy, so that closed paths gain no energy:
 *   F = ∂W/∂D = F_0 τ + W_0 ∂τ/∂D,   M = ∂W/∂θ at one δ = F dh/dθ + W_0 ∂τ/∂θ,
 * F along the body's normal, M about the tip, towards the upright position. τ(D, 0) = 1.
 *
 * τ = ρ η. η is the bicubic Hermite interpolant of nodes in x = √(D/D_m) and y = θ/θ_m. ρ is 1 or,
 * for a tool with a flat end, whose force falls fast with the tilt, that of a flat end on a
 * half-space (tiltedFlatWork) at s = κ h(θ)/D, so that η is smooth. Beyond D_m η is constant,
 * beyond θ_m the tilt counts as θ_m. h is the cubic Hermite interpolant of drops and offsets.
 *
 * Bodies whose points differ in more than their modulus have several laws, and each point its
 * weights, of sum 1. Immutable; allocates and throws nothing after construction.
 */
class PALPATE_EXPORT TiltTable
{
public:
  TiltTable() = default;
  /// `drops`: h and dh/dθ at each θ_k. `nodes`: of each law, each x, each y: η and its derivatives
  /// by x, by y, by both. Numbers without fault by faultOf.
  TiltTable(const TiltTerms& terms, const double* drops, const double* nodes);

  /// What is wrong, with the number, or "".
  static std::string faultOf(const TiltTerms& terms, const double* drops, const double* nodes);
  static std::size_t dropCount(const TiltTerms& terms) noexcept
  {
    return 2 * static_cast<std::size_t>(terms.drops);
  }
  static std::size_t nodeCount(const TiltTerms& terms) noexcept
  {
    return 4 * static_cast<std::size_t>(terms.laws) * static_cast<std::size_t>(terms.depths) *
      static_cast<std::size_t>(terms.angles);
  }

  const TiltTerms& terms() const noexcept { return this->Terms; }
  const std::vector<double>& drops() const noexcept { return this->Drops; }
  const std::vector<double>& nodes() const noexcept { return this->Nodes; }

  /// Whether a tilt exceeds the largest by more than rounding.
  bool isBeyond(double angle) const noexcept
  {
    constexpr double rounding = 1e-9;
    return angle > this->Terms.largest + rounding;
  }
  /// θ >= 0, rad.
  DeepestPoint deepest(double angle) const noexcept;
  /// D > 0, mm; θ >= 0, rad; one weight per law.
  TiltFactor at(double depth, double angle, const double* weights) const noexcept;
  /// The same of a table of one law.
  TiltFactor at(double depth, double angle) const noexcept
  {
    constexpr double whole = 1.0;
    return this->at(depth, angle, &whole);
  }

private:
  TiltTerms Terms;
  std::vector<double> Drops;
  std::vector<double> Nodes;
};
} // namespace palpate

#endif
