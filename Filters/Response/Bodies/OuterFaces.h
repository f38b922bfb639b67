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
/// Returns the outer faces of the three-dimensional cells of a data set. If the data set has no
/// such cells, returns its cells. `notes` receives the number of omitted cells of lower dimension.
/// `fault` names the first cell whose orientation differs from that of the majority. `wholeExtent`
/// is the extent of a structured grid over the pieces of all ranks. Only the faces of this extent
/// belong to the surface. Null means that the grid is whole.
vtkSmartPointer<vtkPolyData> outerFaces(
  vtkDataSet* data, const int* wholeExtent, std::vector<std::string>& notes, std::string& fault);
} // namespace palpate

#endif
