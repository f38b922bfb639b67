// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FiniteContact_h
#define palpate_FiniteContact_h

#include "Solids/FiniteElements/UnitLoads.h"
#include "Mechanics/PalpateExport.h"
#include "Solids/TrueShape/ContactCurve.h"
#include "Solids/TrueShape/ToolFacets.h"

namespace palpate
{
/// Whether a tool can be pressed at finite strain: one without a flat end, whose rim would need a
/// mesh of its own.
inline bool isForFiniteStrain(const AxisymmetricTool& tool)
{
  return !(tool.smallestContactRadius() > 0.0);
}

/**
 * A tool pressed straight into an elastic body of quadratic tetrahedra at finite strain
 * (Neo-Hooke), without friction: the surface moves aside and turns, and pressures act along the
 * tool's own normal. So it decides what DirectContact leaves open, what walls on several sides do,
 * and what a body does that turns away as it bends. The body does not touch itself.
 *
 * Newton's method on the potential of FinitePart, at a few depths, from where the tool first
 * touches, up to three contact radii before the place, down to `deepest` (mm), or as far as an
 * equilibrium is found: where the body gives way suddenly, as a flap that snaps aside, the one that
 * lies downhill. The curve is empty where there is none, in other cells, of several materials, and
 * of tools it is not for. Contact radii are of the undeformed area.
 *
 * `rest` as DirectContact has it: what is around the body moves as at small strain. Where that
 * turns the place by θ, its own length changes by θ²/2 that are not; on a bar held at one end the
 * force is then up to 2.5 θ² too large (FiniteContactTest), which is the curve's error of strain.
 *
 * Four facets over the contact's radius: within 1 % of the axisymmetric solver on a layer. Cost:
 * some 35 factorisations of the stiffness, and more by the way to the place.
 */
PALPATE_EXPORT ContactCurve pressAtFiniteStrain(const ElasticBody& body,
  const AxisymmetricTool& tool, const DirectPlace& at, double deepest,
  const UnitMotion* rest = nullptr);
} // namespace palpate

#endif
