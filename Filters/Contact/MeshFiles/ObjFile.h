// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ObjFile_h
#define palpate_ObjFile_h

#include "Contact/MeshFiles/FileMesh.h"
#include "Mechanics/PalpateExport.h"

#include <istream>

namespace palpate
{
/**
 * Reads the faces of a Wavefront .obj file. Each `v` line is one point, however many texture
 * coordinates and normals the faces assign to it, so that a seam of the texture does not cut the
 * surface. Normals are kept if each point has exactly one normal.
 *
 * A corner is `v`, `v/t`, `v//n` or `v/t/n`. Indices count from 1; negative indices count backwards
 * from the last vertex. Line and point elements of the file are omitted; groups, materials and
 * curves are ignored.
 *
 * The fault names the line. Faults are: text that is not a number, a face with fewer than three
 * corners, and a corner that refers to a missing vertex, texture coordinate or normal.
 */
PALPATE_EXPORT FileMesh readObj(std::istream& file);
} // namespace palpate

#endif
