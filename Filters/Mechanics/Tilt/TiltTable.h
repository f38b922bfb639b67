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
/// The deepest point of a tilted tool, relative to its tip.
struct DeepestPoint
{
  double drop = 0.0;   ///< h, depth below the tip, mm, >= 0
  double offset = 0.0; ///< x = dh/dθ, lateral distance from the tip, mm, >= 0
};

/// The tilt factor τ and its derivatives with respect to the depth D at fixed tilt, and to the tilt
/// θ at fixed depth.
struct TiltFactor
{
  double value = 1.0;
  double byDepth = 0.0;      ///< 1/mm
  double byDepthTwice = 0.0; ///< 1/mm²
  double byAngle = 0.0;      ///< 1/rad
};

/// Parameters of a TiltTable in stored form.
struct TiltTerms
{
  double range = 0.0;   ///< D_m, mm, > 0
  double largest = 0.0; ///< largest tilt, rad, > 0 and less than a right angle
  /// κ >= 0. κ is 3 for a tool with a flat end. When such a tool is tilted, its rim touches first,
  /// and its force depends on the ratio of depth and drop.
  double dropScale = 0.0;
  int depths = 0; ///< nodes x_i = i/(depths - 1), 2 or more
  int angles = 0; ///< nodes y_j = j/(angles - 1), 2 or more
  int drops = 0;  ///< nodes θ_k = largest k/(drops - 1), 2 or more
  int laws = 0;   ///< 1 to MostLaws

  static constexpr int MostLaws = 16;
  static constexpr int MostNodes = 256; ///< largest number of depths, of angles and of drops

  bool areFelt() const noexcept { return this->laws > 0; }
};

/// Returns the fault of the parameters with the value, or "".
PALPATE_EXPORT std::string faultOfTilts(const TiltTerms& terms);

/**
 * The effect of tilt on the force of a tool. W_0(D) is the work of pressing the upright tool to the
 * depth D. If the deepest point of the tool tilted by θ is at the depth D, the work is
 *   W(D, θ) = W_0(D) τ(D, θ),  D = δ + h(θ),
 * where δ is the depth of the tip, which is on the axis, and h the drop of the deepest point. Force
 * and torque follow from this energy, so that closed paths gain no energy:
 *   F = ∂W/∂D = F_0 τ + W_0 ∂τ/∂D,   M = ∂W/∂θ at one δ = F dh/dθ + W_0 ∂τ/∂θ.
 * F acts along the body's normal. M acts about the tip, towards the upright position. τ(D, 0) = 1.
 *
 * τ = ρ η. η is the bicubic Hermite interpolant between nodes in x = √(D/D_m) and y = θ/θ_m. ρ is
 * 1, except for a tool with a flat end, whose force decreases fast with the tilt. Then ρ is that of
 * a flat end on a half-space (tiltedFlatWork) at s = κ h(θ)/D, which makes η smooth. Beyond D_m, η
 * is constant; a tilt beyond θ_m counts as θ_m. h is the cubic Hermite interpolant of the stored
 * drops and offsets.
 *
 * A body whose points differ in more than their modulus has several laws. Each point then has one
 * weight per law; the weights have the sum 1. Immutable; no function allocates or throws after
 * construction.
 */
class PALPATE_EXPORT TiltTable
{
public:
  TiltTable() = default;
  /// `drops` has h and dh/dθ at each θ_k. `nodes` has η and its derivatives with respect to x, to y
  /// and to both, for each law, each x and each y. The values must pass faultOf().
  TiltTable(const TiltTerms& terms, const double* drops, const double* nodes);

  /// Returns the fault of the data with the value, or "".
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

  /// Returns whether a tilt exceeds the largest tilt by more than rounding.
  bool isBeyond(double angle) const noexcept
  {
    constexpr double rounding = 1e-9;
    return angle > this->Terms.largest + rounding;
  }
  /// Returns the deepest point at the tilt θ >= 0, rad.
  DeepestPoint deepest(double angle) const noexcept;
  /// Returns τ at D > 0, mm, and θ >= 0, rad. `weights` has one weight per law.
  TiltFactor at(double depth, double angle, const double* weights) const noexcept;
  /// Returns the factor of a table with one law.
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
