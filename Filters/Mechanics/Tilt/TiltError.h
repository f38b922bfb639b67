// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TiltError_h
#define palpate_TiltError_h

#include "Mechanics/PalpateExport.h"

namespace palpate
{
/// A tilted contact on a layer, in dimensionless numbers.
struct TiltedLayer
{
  double radius = 0.0;  ///< contact radius of the tool upright, as deep in a half-space, over the
                        ///< thickness of the layer; 0 on a half-space
  double stretch = 1.0; ///< F(D, θ)/F(D, 0) on that layer
  double rim = 0.0;     ///< κ h/D of a tool with a flat end (TiltTerms::dropScale), else 0
};

/**
 * The relative error of the force of a tilted tool on a bonded layer by its equivalent profile of
 * revolution (TiltedTool.h), as the base acts differently on a contact that is longer than wide, or
 * on a rim. With T the stretch, where it is more than 1, ρ the radius times √T and
 * g = ρ³/(ρ³ + 0.22), pointed tools 0.36 (1 - T^-1.2) g, flat ends 0.18 s²/(1 + s²) g, s the rim's
 * drop, an envelope of the results of boundary elements on layers, ν = 0.45
 * (Data/Reference/tilt/tilt_layer_nu0.45.csv). At least that of the table on a half-space
 * (TiltNodes.h): 2 % of flat ends that touch in part, s > 1/3, and 3 % where less than half of one
 * does, s > 1; 0.5 % of pointed ends and of flat ones that touch as a whole. 0 for spherical ends,
 * and upright.
 */
PALPATE_EXPORT double tiltError(const TiltedLayer& contact) noexcept;
} // namespace palpate

#endif
