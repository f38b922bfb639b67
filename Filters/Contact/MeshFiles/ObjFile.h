// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ObjFile_h
#define palpate_ObjFile_h

#include "Contact/MeshFiles/FileMesh.h"
#include "Mechanics/PalpateExport.h"

#include <istream>

namespace palpate
{
/**
 * Reads the faces of a Wavefront .obj file. Each `v` is one point, however many texture coordinates
 * and normals the faces assign to it, so that a seam of the texture does not cut the surface.
 * Normals are kept if each point has exactly one.
 *
 * A corner is `v`, `v/t`, `v//n` or `v/t/n`. Indices count from 1; negative indices count backwards
 * from the last one. Lines and points are omitted; groups, materials and curves are ignored.
 *
 * The fault names the line: text that is not a number, a face of fewer than three corners, a corner
 * that refers to a missing vertex, texture coordinate or normal.
 */
PALPATE_EXPORT FileMesh readObj(std::istream& file);
} // namespace palpate

#endif
