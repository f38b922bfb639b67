// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PlyFault_h
#define palpate_PlyFault_h

#include "Mechanics/PalpateExport.h"

#include <istream>
#include <string>

namespace palpate
{
/// Why a .ply file is unfit for vtkPLYReader, which crashes on damaged ones, or "". Names the line
/// of the header, or the row of an element. Reads the file once.
PALPATE_EXPORT std::string plyFault(std::istream& file);
} // namespace palpate

#endif
