// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ObjFile_h
#define palpate_ObjFile_h

#include "Contact/MeshFiles/FileMesh.h"
#include "Mechanics/PalpateExport.h"

#include <istream>

namespace palpate
{
/**
 * The faces of a Wavefront .obj file. Each `v` is one point, however many texture coordinates and
 * normals the faces give it, so that a seam of the texture does not cut the surface. Normals are
 * kept if each point has one and only one.
 *
 * A corner is `v`, `v/t`, `v//n` or `v/t/n`, counted from 1, or from the last one back if negative.
 * Lines and points are left out; groups, materials and curves are ignored.
 *
 * Faults name the line: text that is not a number, a face of fewer than three corners, a corner
 * that names a missing vertex, texture coordinate or normal.
 */
PALPATE_EXPORT FileMesh readObj(std::istream& file);
} // namespace palpate

#endif
