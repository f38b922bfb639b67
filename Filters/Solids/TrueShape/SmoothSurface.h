// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SmoothSurface_h
#define palpate_SmoothSurface_h

#include "Solids/FiniteElements/ElasticBody.h"

namespace palpate
{
/**
 * Returns the position of a surface point on the smooth surface that the body's facets represent.
 *
 * This is the position of the point itself, except for mid-edge nodes of quadratic tetrahedra that
 * were converted from linear tetrahedra, because such nodes are on the chords of a curved surface.
 * These nodes are lifted by ((n₂·e)n₂ - (n₁·e)n₁)/8, with the edge e and the normals n₁, n₂ at the
 * ends of the edge (Vlachos, Peters, Boyd and Mitchell 2001). If the nodes stayed on the chords,
 * the surface would have twice the true curvature around its corners, and no curvature around the
 * mid-edge nodes.
 */
Eigen::Vector3d smoothPosition(const ElasticBody& body, std::int32_t point);
} // namespace palpate

#endif
