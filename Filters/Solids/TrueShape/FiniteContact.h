// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FiniteContact_h
#define palpate_FiniteContact_h

#include "Solids/FiniteElements/UnitLoads.h"
#include "Mechanics/PalpateExport.h"
#include "Solids/TrueShape/ContactCurve.h"
#include "Solids/TrueShape/ToolFacets.h"

namespace palpate
{
/// Returns whether a tool can be pressed at finite strain. The tool must have no flat end, because
/// the rim of a flat end would need a finer mesh.
inline bool isForFiniteStrain(const AxisymmetricTool& tool)
{
  return !(tool.smallestContactRadius() > 0.0);
}

/**
 * A tool pressed straight into an elastic body of quadratic tetrahedra at finite strain
 * (Neo-Hooke), without friction. The solution includes tangential motion and rotation of the
 * surface. The pressures act along the tool's normal. This solution is valid where DirectContact is
 * uncertain: for contact with walls on several sides, and for bodies that rotate away from the tool
 * when they bend. Contact of the body with itself is not modelled.
 *
 * Newton's method minimises the potential of FinitePart at a few depths. The solution starts where
 * the tool first touches, which may be up to three contact radii before the tip reaches the point.
 * It continues to `deepest` (mm), or to the last depth with an equilibrium. If the body is
 * unstable, such as a flap that snaps aside, the solution follows the equilibrium of lower energy.
 * The curve is empty if no equilibrium is found. It is also empty for elements of other types, for
 * several materials, and for tools with a flat end. Contact radii refer to the undeformed area.
 *
 * `rest` is used as in DirectContact, with small strain in the surrounding body. If the motion of
 * the surrounding body rotates the place by θ, the assumption of small strain gives erroneous
 * length changes of θ²/2. On a bar held at one end, the relative error of the force is then up to
 * 2.5 θ² (FiniteContactTest). This is the strain error of the curve.
 *
 * With four facets over the contact radius, the force on a layer is within 1 % of that of the
 * axisymmetric solver. Cost: about 35 factorisations of the stiffness, and more if the distance
 * from the first touch to the point is long.
 */
PALPATE_EXPORT ContactCurve pressAtFiniteStrain(const ElasticBody& body,
  const AxisymmetricTool& tool, const DirectPlace& at, double deepest,
  const UnitMotion* rest = nullptr);
} // namespace palpate

#endif
