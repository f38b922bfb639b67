// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * The compliance a patch load would have on a half-space of the same elements.
 *
 * The energy of a patch on a body is that of the patch on a half-space (16/(3π²E*c) for a disc of
 * radius c, and large) plus the effect of the body's shape and supports, which is wanted. Elements
 * of the size of the patch have an error of some per cent in the large part, more than the whole
 * effect. So the large part is computed with the same elements: those within `reach` of the point
 * are cut out, flattened so that their free surface is the plane z = 0 (the effect of curvature
 * stays in the body's energy), made of one material, loaded by the same nodal forces, and given the
 * exact displacement of the half-space (Boussinesq 1885, summed over the load) wherever they were
 * cut or the body ends. The missing energy is then the same in both and cancels.
 *
 * The error of linear elements beyond the cut is proportional to h² ∫ r⁻⁶ dV (the square of the
 * second derivative of the strain of 1/r). Two cuts, one within the other, give the factor; the
 * elements of the body beyond, the integral.
 *
 * On regular grids most cut-outs are alike: equal ones (to 1e-7 of the spacing) are computed once.
 */
#ifndef palpate_PatchSelfTerm_h
#define palpate_PatchSelfTerm_h

#include "Solids/FiniteElements/ElasticElement.h"
#include "Solids/FiniteElements/PatchCut.h"

namespace palpate
{
/// Compliances (mm/N) for E = 1 MPa, by cut and load; NaN when an element is inverted by
/// flattening.
using SelfTerms = std::array<std::array<double, 2>, 2>;
SelfTerms patchSelfTerms(const LocalPatch& patch);

/// Displacements of the nodes of the outer cut under each load (3 × nodes, mm/N for E = 1 MPa, in
/// the tangent frame: z into the body); NaN when an element is inverted by flattening.
std::array<Eigen::Matrix3Xd, 2> patchMotions(const LocalPatch& patch);
} // namespace palpate

#endif
