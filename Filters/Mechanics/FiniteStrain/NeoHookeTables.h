// SPDX-License-Identifier: BSD-3-Clause
#ifndef NeoHookeTables_h
#define NeoHookeTables_h

#include "Mechanics/FiniteStrain/StrainTable.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <memory>

namespace palpate
{
class AxisymmetricTool;

/// c of Neo-Hooke for a sphere, flat or cone of 45° to 75° on a half-space down to `deepest` (mm),
/// at the tool's size; null for another tool, and deeper than 1.8 times the tables' end, which is a
/// radius for a sphere and 1.3 for a flat: beyond that end the error grows.
std::unique_ptr<StrainTable> neoHookeOnHalfSpace(const AxisymmetricTool& tool, double deepest);

/// The same for bonded layers: a sphere on layers of half to four radii, to half of the thickness;
/// null if `deepest` is more than 0.7 of the thinnest. Or a sphere or a flat on layers from two
/// radii on, to the depth of thickLayerReach, and with a growing error to 2.25 times that of the
/// thinnest; thicknesses above sixteen radii count as sixteen.
std::unique_ptr<StrainTable> neoHookeOnLayers(
  const AxisymmetricTool& tool, double thinnest, double thickest, double deepest);

/// The depth of the tables of thick layers, for a sphere or a flat of that radius, mm.
StrainReach thickLayerReach(ToolShape shape, double radius);
} // namespace palpate

#endif
