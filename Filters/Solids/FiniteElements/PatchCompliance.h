// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * The structural (global) compliance of a body at points of its surface:
 * C_g(X) = lim_{y→X} [G_nn(X,y) - 1/(πE*|X-y|)], the regular part of the Green function.
 *
 * By Castigliano's theorem the mean normal displacement of a uniform patch of 1 N is twice its
 * energy, bᵀK⁻¹b. The displacement of the same patch on a half-space (PatchSelfTerm) is subtracted.
 * The bias grows as the square of the patch's radius c and is eliminated: C_g = (4 C(c) - C(2c)) /
 * 3.
 *
 * E* is that of the point: the mean E and ν of the elements at it. Where the material changes, C_g
 * is the effect that the other material has on a half-space of the point's material. It is accurate
 * only if the material is constant within a few elements of the point.
 */
#ifndef palpate_PatchCompliance_h
#define palpate_PatchCompliance_h

#include "Solids/FiniteElements/ElasticBody.h"
#include "Mechanics/PalpateExport.h"

namespace palpate
{
/// The values are those of ResponseStatus.
enum class PatchStatus : std::uint8_t
{
  Valid = 0,
  Degenerate = 1, ///< no normal, or elements too distorted to be flattened
  OutOfReach = 4, ///< the patch covers points that are fixed
  Edge = 5 ///< the patch extends over an edge: the surface turns by more than 30° under the patch
};

/// The global compliance of each point.
struct PatchCompliances
{
  std::vector<double> compliance; ///< mm/N, per surface point; NaN where the status is not Valid
  std::vector<PatchStatus> status;
};

/**
 * Computes the compliances at the given surface points of a factorised body; the other points are
 * NaN and Degenerate. `radius` (mm) of the smaller patch; 0: PatchSpacings (PatchSite) times the
 * spacing at each point. The larger patch has twice the radius.
 *
 * Local parts are computed by threadCount() threads; the result is bit-identical for any number of
 * them. The result is empty if the observer stopped the work.
 */
PALPATE_EXPORT PatchCompliances patchCompliances(const ElasticBody& body,
  const std::vector<std::int32_t>& points, double radius, const WorkObserver& observer);

/// Returns the patch of 1 N at a surface point as forces on the nodes (3 × nodes). If the patch
/// extends over an edge, the whole force acts at the point.
PALPATE_EXPORT Eigen::Matrix3Xd patchForces(
  const ElasticBody& body, std::int32_t point, double radius);

/**
 * Fills points without a value from valid points around them: the six nearest along the edges of
 * the surface, weighted by 1/distance². A part of the surface without valid points keeps NaN.
 */
PALPATE_EXPORT void spreadValidCompliances(
  const BodySurface& surface, PatchCompliances& compliances);
} // namespace palpate

#endif
