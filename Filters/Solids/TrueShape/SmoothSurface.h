// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SmoothSurface_h
#define palpate_SmoothSurface_h

#include "Solids/FiniteElements/ElasticBody.h"

namespace palpate
{
/**
 * Where a surface point lies on the smooth surface that the body's facets stand for.
 *
 * That is where it is, but for the mid-edge nodes of quadratic tetrahedra that were made from
 * linear ones and lie on the chords of a curved surface: those are lifted by what the normals at
 * both ends say, ((n₂·e)n₂ - (n₁·e)n₁)/8 for the edge e (Vlachos, Peters, Boyd and Mitchell 2001).
 * On the chord a tool would find twice the true curvature of the surface around a corner, and none
 * around them.
 */
Eigen::Vector3d smoothPosition(const ElasticBody& body, std::int32_t point);
} // namespace palpate

#endif
