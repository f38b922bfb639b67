// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PlyFault_h
#define palpate_PlyFault_h

#include "Mechanics/PalpateExport.h"

#include <istream>
#include <string>

namespace palpate
{
/// Returns the reason why a .ply file must not be given to vtkPLYReader, which crashes on damaged
/// files; "" if the file can be read. The text names the line of the header, or the row of an
/// element. Reads the file once.
PALPATE_EXPORT std::string plyFault(std::istream& file);
} // namespace palpate

#endif
