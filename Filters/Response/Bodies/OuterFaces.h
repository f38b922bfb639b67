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
/// The outer faces of the three-dimensional cells of a data set. If it has no such cells, the cells
/// themselves. Notes give the number of cells of fewer dimensions that are left out. A fault names
/// the first cell that winds against the majority. `wholeExtent`: extent of the pieces of all ranks
/// of a structured grid; only its faces are surface. Null: the grid is whole.
vtkSmartPointer<vtkPolyData> outerFaces(
  vtkDataSet* data, const int* wholeExtent, std::vector<std::string>& notes, std::string& fault);
} // namespace palpate

#endif
