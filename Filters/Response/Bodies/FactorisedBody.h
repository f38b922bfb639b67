// SPDX-License-Identifier: BSD-3-Clause
#ifndef FactorisedBody_h
#define FactorisedBody_h

#include "Mechanics/FiniteElements/ElasticBody.h"

#include <functional>
#include <string>

class vtkAlgorithm;
class vtkDataArray;
class vtkUnstructuredGrid;

namespace palpate
{
/// What a filter of elastic bodies is told of material and solver.
struct FactorRequest
{
  ElasticMaterial material;        ///< of cells without an array
  vtkDataArray* young = nullptr;   ///< per cell, MPa; null: the constant
  vtkDataArray* poisson = nullptr; ///< per cell; null: the constant
  int solver = 0;                  ///< a StiffnessFactor::Kind
  double memoryLimit = 0.0;        ///< MiB; 0: nine tenths of what the machine has available
};

/// Whether elements can have it for Poisson's ratio: 0 to LargestPoissonRatio.
bool isElementRatio(double ratio);

/// What is wrong with a request, naming the property, or "".
std::string checkFactorRequest(const FactorRequest& request);

/// Bytes that may be used, by a limit in MiB or, of 0, by what is available now.
double allowedMemory(double memoryLimit);

/// The cell array that a filter was told to process, null if it was told none: "", or what is wrong
/// with it. `find` fetches the one of a filter that names none.
std::string findCellArray(vtkAlgorithm* filter, vtkUnstructuredGrid* grid, int index,
  const std::function<vtkDataArray*(int)>& find, vtkDataArray*& array);

/// The same of a point array.
std::string findPointArray(vtkAlgorithm* filter, vtkUnstructuredGrid* grid, int index,
  const std::function<vtkDataArray*(int)>& find, vtkDataArray*& array);

/// Makes `body` of the grid and its point array `Fixed`, and factorises it. Returns what is wrong,
/// or "". `memory` (MiB): what the factorisation takes, also where that is refused. Where
/// `goOn(share of the work)` says false it ends at once, and `body` is not to be used.
std::string factoriseBody(vtkUnstructuredGrid* grid, const FactorRequest& request,
  const std::function<bool(double)>& goOn, ElasticBody& body, double& memory, bool& ended);
} // namespace palpate

#endif
