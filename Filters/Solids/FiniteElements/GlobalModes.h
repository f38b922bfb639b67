// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * Motion of a whole body under a force at any point: a Green function of low rank.
 *
 * H(x,X) is the motion of the surface at x per force at X, without the dent (RegularField). It is
 * symmetric, H(x,X) = H(X,x)ᵀ (Betti), and smooth, so that a few products approximate it:
 *     H(x,X) ≈ Σ_k s_k φ_k(x) φ_k(X)ᵀ,  s_k = ±1,  φ_k in sqrt(mm/N).
 * A force F along -n at X moves x by u = -F Σ_k s_k φ_k(x) (n·φ_k(X)). The force moves X itself
 * inwards by F Σ_k s_k (n·φ_k(X))², which is C_g F without the neglected part.
 *
 * The modes follow from the fields g_j(x) = H(x,X_j) n_j of landmarks spread over the surface
 * (farthest point sampling; Nyström 1930; Williams and Seeger 2001): G_ij = n_i·g_j(X_i) = Σ_k V_ik
 * L_k V_jk and φ_k = Σ_j g_j V_jk / √|L_k|, in descending order of |L_k|. With all modes the fields
 * of the landmarks are reproduced exactly. L_k is negative where a near support makes the surface
 * stiffer than that of a half-space.
 */
#ifndef palpate_GlobalModes_h
#define palpate_GlobalModes_h

#include "Mechanics/PalpateExport.h"
#include "Solids/FiniteElements/PatchCompliance.h"

namespace palpate
{
/// Largest number of modes. The graphics card limits this number, because it reads three numbers
/// per point and mode.
constexpr int MostGlobalModes = 6;
/// Number of landmarks per mode.
constexpr int LandmarksPerMode = 8;
/// Eigenvalues below this fraction of the largest are rounding errors.
constexpr double ModeRounding = 1e-10;

/// A few modes that approximate the motion of the whole surface under a force at any point.
struct GlobalModes
{
  /// φ_k, one matrix of 3 × surface points per mode, in sqrt(mm/N). If the body has fewer modes,
  /// the last matrices are zero.
  std::vector<Eigen::Matrix3Xd> fields;
  std::vector<int> signs;              ///< s_k: 1 or -1
  std::vector<std::int32_t> landmarks; ///< surface points from whose fields the modes were computed
  /// Error of the fields: |G - Gᵀ| / |G + Gᵀ|, which is 0 for exact fields (Betti).
  double asymmetry = 0.0;
  /// Root mean square of C_g - Σ_k s_k (n·φ_k)² over the valid points, relative to the root mean
  /// square of C_g.
  double neglected = 0.0;
};

/// Returns points by farthest-point sampling. Starts with `first`, and then repeatedly adds the
/// point of `points` that is farthest from all points chosen before.
std::vector<std::int32_t> spreadPoints(const BodySurface& surface,
  const std::vector<std::int32_t>& points, std::int32_t first, std::size_t wanted);

/// Computes the `count` largest modes from the fields g_j of the landmarks (3 × surface points
/// each). Does not set `neglected`.
GlobalModes modesOf(const ElasticBody& body, const std::vector<std::int32_t>& landmarks,
  const std::vector<Eigen::Matrix3Xd>& pulled, int count);

/**
 * Computes the `count` largest modes of a factorised body. The number of landmarks is
 * LandmarksPerMode times `count`; they are chosen among the points with a valid compliance. If
 * there are no such points, every mode is zero. `radius` is that of patchCompliances(). Cost: one
 * solution per landmark. The result has no fields if the observer stopped the work.
 */
PALPATE_EXPORT GlobalModes globalModes(const ElasticBody& body, const PatchCompliances& compliances,
  double radius, int count, const WorkObserver& observer);
} // namespace palpate

#endif
