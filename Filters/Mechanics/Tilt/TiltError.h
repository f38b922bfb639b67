// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TiltError_h
#define palpate_TiltError_h

#include "Mechanics/PalpateExport.h"

namespace palpate
{
/// A tilted contact on a layer or half-space, in dimensionless numbers.
struct TiltedLayer
{
  /// Contact radius of the upright tool at the same depth in a half-space, divided by the thickness
  /// of the layer; 0 on a half-space.
  double radius = 0.0;
  double stretch = 1.0; ///< ratio F(D, θ)/F(D, 0) on that layer
  /// κ h/D for a tool with a flat end, with the drop h (TiltTerms::dropScale); else 0.
  double rim = 0.0;
};

/**
 * Returns the relative error of the force of a tilted tool on a bonded layer, if the force is
 * computed from the equivalent profile of revolution (TiltedTool.h). The error arises because the
 * effect of the base on an elongated contact or on a rim differs from that on a circular contact.
 *
 * Let T be `stretch` (at least 1), ρ = `radius` √T, g = ρ³/(ρ³ + 0.22) and s = `rim`. The error is
 * the larger of
 *   0.36 (1 - T^-1.2) g, for pointed tools, and
 *   0.18 s²/(1 + s²) g, for flat ends.
 * This is an envelope of results of boundary elements on layers with ν = 0.45
 * (Data/Reference/tilt/tilt_layer_nu0.45.csv).
 *
 * The result is at least the error of the table on a half-space, from boundary elements
 * (Data/Reference/tilt/tilt_bem.csv): 0.5 % for pointed ends; for flat ends 3 % for s > 3, 2 % for
 * s > 1, and 0.6 % for s <= 1, where the whole end touches. It is 0 for spherical ends and for
 * upright tools.
 */
PALPATE_EXPORT double tiltError(const TiltedLayer& contact) noexcept;
} // namespace palpate

#endif
