// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * The structural (global) compliance of a body at points of its surface:
 * C_g(X) = lim_{y→X} [G_nn(X,y) - 1/(πE*|X-y|)], the regular part of the Green function.
 *
 * By Castigliano's theorem, the mean normal displacement under a uniform patch load of 1 N is twice
 * its strain energy, bᵀK⁻¹b. The displacement of the same patch on a half-space (PatchSelfTerm) is
 * subtracted. The remaining bias grows as the square of the patch's radius c. Two radii eliminate
 * it: C_g = (4 C(c) - C(2c)) / 3.
 *
 * E* follows from the mean E and ν of the elements at the point. Where the material changes, C_g
 * includes the effect of the other material compared with a half-space of the point's material. C_g
 * is accurate only if the material is constant within a few elements of the point.
 */
#ifndef palpate_PatchCompliance_h
#define palpate_PatchCompliance_h

#include "Solids/FiniteElements/ElasticBody.h"
#include "Mechanics/PalpateExport.h"

namespace palpate
{
/// Status of a patch. The values are those of ResponseStatus.
enum class PatchStatus : std::uint8_t
{
  Valid = 0,
  Degenerate = 1, ///< the point has no normal, or the elements are too distorted to be flattened
  OutOfReach = 4, ///< the patch covers points that are fixed
  /// The patch extends over an edge, where the normal of the surface varies by more than 30° under
  /// the patch.
  Edge = 5
};

/// The global compliance of each point.
struct PatchCompliances
{
  std::vector<double> compliance; ///< mm/N, per surface point; NaN if the status is not Valid
  std::vector<PatchStatus> status;
};

/**
 * Computes the compliances at the given surface points of a factorised body. The other points get
 * the value NaN and the status Degenerate. `radius` is the radius of the smaller patch, mm. If it
 * is 0, the radius is PatchSpacings (PatchSite) times the spacing at each point. The larger patch
 * has twice this radius.
 *
 * threadCount() threads compute the local parts. The result is bit-identical for any number of
 * threads. It is empty if the observer stopped the work.
 */
PALPATE_EXPORT PatchCompliances patchCompliances(const ElasticBody& body,
  const std::vector<std::int32_t>& points, double radius, const WorkObserver& observer);

/// Returns the load of 1 N on the patch at a surface point, as forces on the nodes (3 × nodes). If
/// the patch extends over an edge, the whole force acts at the point.
PALPATE_EXPORT Eigen::Matrix3Xd patchForces(
  const ElasticBody& body, std::int32_t point, double radius);

/**
 * Fills the points without a value. The value is the mean of the six nearest valid points along the
 * edges of the surface, weighted by 1/distance². In a part of the surface without valid points, the
 * values stay NaN.
 */
PALPATE_EXPORT void spreadValidCompliances(
  const BodySurface& surface, PatchCompliances& compliances);
} // namespace palpate

#endif
