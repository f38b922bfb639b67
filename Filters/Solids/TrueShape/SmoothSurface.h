// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SmoothSurface_h
#define palpate_SmoothSurface_h

#include "Solids/FiniteElements/ElasticBody.h"

namespace palpate
{
/**
 * Place of a surface point on the smooth surface that the body's facets represent.
 *
 * This is the point's own place, except for mid-edge nodes of quadratic tetrahedra that were made
 * from linear tetrahedra: such nodes are on the chords of a curved surface. These nodes are lifted
 * by ((n₂·e)n₂ - (n₁·e)n₁)/8, with the edge e and the normals n₁, n₂ at its ends (Vlachos, Peters,
 * Boyd and Mitchell 2001). With nodes on the chords a tool would find twice the true curvature
 * around a corner of the surface, and no curvature around the nodes.
 */
Eigen::Vector3d smoothPosition(const ElasticBody& body, std::int32_t point);
} // namespace palpate

#endif
