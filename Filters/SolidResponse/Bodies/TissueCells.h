// SPDX-License-Identifier: BSD-3-Clause
#ifndef TissueCells_h
#define TissueCells_h

#include "Mechanics/SharedWork.h"
#include "Solids/FiniteElements/ElasticElement.h"

#include <map>
#include <string>

class vtkDataArray;
class vtkImageData;
class vtkUnstructuredGrid;

namespace palpate
{
using TissueMap = std::map<double, ElasticMaterial>;

/// An image and the materials for its values; see vtkScannedMaterial.
struct TissueScan
{
  vtkImageData* image = nullptr;
  vtkDataArray* values = nullptr; ///< one component per point of the image
  TissueMap map;                  ///< materials by value of the image; not empty
  /// Whether values are labels. If not, they are quantities on a continuous scale.
  bool hasLabels = true;
  ElasticMaterial outside; ///< material outside the image
  int subdivisions = 4;    ///< number of sample points along each side of a cell
};

/// Copies the grid to `output` and adds the cell arrays YoungsModulus and PoissonRatio. Returns ""
/// or an error message. `output` is empty if the observer stopped the work.
std::string mapTissues(vtkUnstructuredGrid* grid, const TissueScan& scan,
  const WorkObserver& observer, vtkUnstructuredGrid* output);
} // namespace palpate

#endif
