// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DataFault_h
#define palpate_DataFault_h

#include <string>

class vtkDataSet;

namespace palpate
{
/// What a damaged file has left in a data set that would lead a filter out of its arrays, or "": an
/// array of another length than points or cells, a cell of a kind that is unknown or has another
/// number of points, an image without voxels for its size.
/// `memory`: bytes that its cells may need when they are looked at.
std::string dataFault(vtkDataSet* data, double memory);
} // namespace palpate

#endif
