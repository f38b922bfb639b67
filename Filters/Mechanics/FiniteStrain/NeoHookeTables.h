// SPDX-License-Identifier: BSD-3-Clause
#ifndef NeoHookeTables_h
#define NeoHookeTables_h

#include "Mechanics/FiniteStrain/StrainTable.h"

#include <memory>

namespace palpate
{
class AxisymmetricTool;

/// c of Neo-Hooke for a sphere, flat or cone of 45° to 75° on a half-space down to `deepest` (mm),
/// at the tool's size; null for another tool, and deeper than the tables go.
std::unique_ptr<StrainTable> neoHookeOnHalfSpace(const AxisymmetricTool& tool, double deepest);

/// The same for a sphere on bonded layers of half to four radii, to half of each; null if `deepest`
/// is more than 0.7 of the thinnest.
std::unique_ptr<StrainTable> neoHookeOnLayers(
  const AxisymmetricTool& tool, double thinnest, double thickest, double deepest);
} // namespace palpate

#endif
