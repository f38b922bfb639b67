// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * Compliance of a patch load on a half-space of the same elements.
 *
 * The compliance of a patch on a body is that of the patch on a half-space (16/(3π²E*c) for a disc
 * of radius c) plus the effect of the body's shape and supports. The first part is large, but only
 * the second part is needed. With elements of the size of the patch, the error of the first part is
 * a few per cent, which exceeds the second part. Therefore the first part is computed with the same
 * elements. The elements within `reach` of the point are cut out and flattened so that their free
 * surface is the plane z = 0 (the effect of curvature remains in the energy of the body). All these
 * elements get the same material, and the nodal forces are those on the body. At the cut, and where
 * the body ends, the nodes have the exact displacement of the half-space (Boussinesq 1885, summed
 * over the load). The discretisation error of the energy is then the same in both computations and
 * cancels.
 *
 * The error of linear elements beyond the cut is proportional to h² ∫ r⁻⁶ dV (the square of the
 * second derivative of the strain of 1/r). The factor is determined from two cuts, one inside the
 * other. The integral is taken over the elements of the body beyond the cut.
 *
 * On regular grids, most cut-outs are equal (to 1e-7 of the spacing). Equal cut-outs are computed
 * once.
 */
#ifndef palpate_PatchSelfTerm_h
#define palpate_PatchSelfTerm_h

#include "Solids/FiniteElements/ElasticElement.h"
#include "Solids/FiniteElements/PatchCut.h"

namespace palpate
{
/// Compliances (mm/N) for E = 1 MPa, indexed by cut and load. They are NaN if flattening inverts an
/// element.
using SelfTerms = std::array<std::array<double, 2>, 2>;
SelfTerms patchSelfTerms(const LocalPatch& patch);

/// Returns the displacements of the nodes of the outer cut under each load (3 × nodes, mm/N for E =
/// 1 MPa, in the tangent frame with z into the body). They are NaN if flattening inverts an
/// element.
std::array<Eigen::Matrix3Xd, 2> patchMotions(const LocalPatch& patch);
} // namespace palpate

#endif
