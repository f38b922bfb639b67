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
/// The outer faces of the three-dimensional cells of a data set; the cells themselves if it has
/// none of three dimensions. Notes say how many cells of fewer dimensions are left out. A fault
/// names the first cell that winds against the most. `wholeExtent`: that of all ranks' pieces of a
/// structured grid, of which only the faces are surface; null: the grid is whole.
vtkSmartPointer<vtkPolyData> outerFaces(
  vtkDataSet* data, const int* wholeExtent, std::vector<std::string>& notes, std::string& fault);
} // namespace palpate

#endif
