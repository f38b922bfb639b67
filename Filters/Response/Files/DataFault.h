// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DataFault_h
#define palpate_DataFault_h

#include <string>

class vtkDataSet;

namespace palpate
{
/// Finds damage in a data set from a file that would make a filter read outside the arrays of the
/// data set. Returns an error message or "". These are damage: an array whose length differs from
/// the number of points or cells; a cell of unknown type or with a wrong number of points; and an
/// image whose number of voxels does not match its size. `memory` is the number of bytes that the
/// inspection of the cells may use.
std::string dataFault(vtkDataSet* data, double memory);
} // namespace palpate

#endif
