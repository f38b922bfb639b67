// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FiniteContact_h
#define palpate_FiniteContact_h

#include "Solids/FiniteElements/UnitLoads.h"
#include "Mechanics/PalpateExport.h"
#include "Solids/TrueShape/ContactCurve.h"
#include "Solids/TrueShape/ToolFacets.h"

namespace palpate
{
/// Whether a tool can be pressed at finite strain. The tool must have no flat end, whose rim would
/// need a finer mesh.
inline bool isForFiniteStrain(const AxisymmetricTool& tool)
{
  return !(tool.smallestContactRadius() > 0.0);
}

/**
 * A tool pressed straight into an elastic body of quadratic tetrahedra at finite strain
 * (Neo-Hooke), without friction. The surface moves aside and turns, and the pressures act along the
 * tool's normal. This solution is valid where DirectContact is uncertain: for contact with walls on
 * several sides, and for bodies that turn away as they bend. Contact of the body with itself is not
 * modelled.
 *
 * The potential of FinitePart is minimised by Newton's method at a few depths. The solution starts
 * where the tool first touches, up to three contact radii before the place, and continues to
 * `deepest` (mm), or to the last depth with an equilibrium. If the body is unstable, such as a flap
 * that snaps aside, the solution follows the equilibrium of lower energy. The curve is empty if no
 * equilibrium is found, for other kinds of elements, for several materials and for tools with a
 * flat end. Contact radii refer to the undeformed area.
 *
 * `rest` is used as in DirectContact: the surrounding body moves as at small strain. If the motion
 * of the surrounding body rotates the place by θ, small strain gives wrong length changes of θ²/2.
 * On a bar held at one end the force is then up to 2.5 θ² too large (FiniteContactTest); this is
 * the strain error of the curve.
 *
 * With four facets over the contact radius the force is within 1 % of the axisymmetric solver on a
 * layer. Cost: about 35 factorisations of the stiffness, and more if the distance from first touch
 * to the place is long.
 */
PALPATE_EXPORT ContactCurve pressAtFiniteStrain(const ElasticBody& body,
  const AxisymmetricTool& tool, const DirectPlace& at, double deepest,
  const UnitMotion* rest = nullptr);
} // namespace palpate

#endif
