// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_StlFile_h
#define palpate_StlFile_h

#include "Contact/MeshFiles/FileMesh.h"
#include "Mechanics/PalpateExport.h"

#include <istream>

namespace palpate
{
/**
 * Reads the facets of a .stl file. Each facet has three points of its own. The normals of the
 * facets are ignored.
 *
 * A binary file has 80 bytes, the number of facets, and 50 bytes for each facet; further bytes are
 * ignored, with a note. An ASCII file begins with "solid", possibly after a byte order mark and
 * blanks; its keywords are in upper or lower case. A file that begins with "solid" is binary if its
 * length matches its number of facets, or if there is a zero byte among its first 84 bytes.
 *
 * The fault names the line or the facet. Faults are: a file that is neither binary nor ASCII, or
 * that ends too early; a keyword out of order; a facet without three corners; a number that is not
 * finite.
 */
PALPATE_EXPORT FileMesh readStl(std::istream& file);
} // namespace palpate

#endif
