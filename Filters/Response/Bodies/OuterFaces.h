// SPDX-License-Identifier: BSD-3-Clause
#ifndef OuterFaces_h
#define OuterFaces_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataSet;

namespace palpate
{
/// Returns the outer faces of the three-dimensional cells of a data set. Without such cells,
/// returns the cells of the data set. Notes give the number of cells of fewer dimensions that are
/// left out. A fault names the first cell that winds against the majority. `wholeExtent`: extent of
/// the pieces of all ranks of a structured grid; only the faces of this extent belong to the
/// surface. Null: the grid is whole.
vtkSmartPointer<vtkPolyData> outerFaces(
  vtkDataSet* data, const int* wholeExtent, std::vector<std::string>& notes, std::string& fault);
} // namespace palpate

#endif
