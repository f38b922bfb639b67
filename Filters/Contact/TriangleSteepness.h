// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TriangleSteepness_h
#define palpate_TriangleSteepness_h

#include "Contact/PackedMesh.h"

#include <cstdint>

namespace palpate
{
/// How far the neighbours of a triangle fall away from its plane, over its smallest altitude: what
/// PackedMesh::isCertainlyNearest asks for, 1/mm, rounded up; infinite where a neighbour lies under
/// the triangle.
float steepnessOf(const PackedMesh& mesh, std::int32_t triangle);
} // namespace palpate

#endif
