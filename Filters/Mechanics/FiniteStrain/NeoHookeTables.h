// SPDX-License-Identifier: BSD-3-Clause
#ifndef NeoHookeTables_h
#define NeoHookeTables_h

#include "Mechanics/FiniteStrain/StrainTable.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <memory>

namespace palpate
{
class AxisymmetricTool;

/// Returns the factor c (StrainCorrection.h) of a Neo-Hooke half-space for a sphere, a flat end or
/// a cone of 45° to 75°, for depths up to `deepest` (mm), scaled to the size of the tool. Returns
/// null for other tools, and if `deepest` is more than 1.8 times the depth at which the table ends.
/// The tables end at a depth of one radius for a sphere and of 1.3 radii for a flat end. Beyond
/// that depth the error increases.
std::unique_ptr<StrainTable> neoHookeOnHalfSpace(const AxisymmetricTool& tool, double deepest);

/// Returns the factor c of Neo-Hooke layers that are bonded to their base. Returns null for other
/// tools.
/// - Thin layers: a sphere on layers of half to four radii, to a depth of half the thickness; null
///   if `deepest` is more than 0.7 of the thinnest layer.
/// - Thick layers: a sphere or a flat end on layers of at least two radii, to the depth of
///   thickLayerReach(), and with an increasing error to 2.25 times that depth for the thinnest
///   layer. For thicknesses above sixteen radii c is that of sixteen radii.
std::unique_ptr<StrainTable> neoHookeOnLayers(
  const AxisymmetricTool& tool, double thinnest, double thickest, double deepest);

/// Returns the largest depth of the tables of thick layers, for a sphere or a flat end. `radius` is
/// in mm.
StrainReach thickLayerReach(ToolShape shape, double radius);
} // namespace palpate

#endif
