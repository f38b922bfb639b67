// SPDX-License-Identifier: BSD-3-Clause
#ifndef FactorisedBody_h
#define FactorisedBody_h

#include "Solids/FiniteElements/ElasticBody.h"

#include <functional>
#include <string>

class vtkAlgorithm;
class vtkDataArray;
class vtkUnstructuredGrid;

namespace palpate
{
/// Material and solver of a filter for elastic bodies.
struct FactorRequest
{
  ElasticMaterial material;        ///< of cells without an array
  vtkDataArray* young = nullptr;   ///< per cell, MPa; null: the constant
  vtkDataArray* poisson = nullptr; ///< per cell; null: the constant
  int solver = 0;                  ///< a StiffnessFactor::Kind
  double memoryLimit = 0.0;        ///< MiB; 0: nine tenths of what the machine has available
};

/// Whether it is a Poisson's ratio that the elements allow: 0 to LargestPoissonRatio.
bool isElementRatio(double ratio);

/// What is wrong with a request, naming the property, or "".
std::string checkFactorRequest(const FactorRequest& request);

/// Bytes that may be used, from a limit in MiB or, if that is 0, from the memory available now.
double allowedMemory(double memoryLimit);

/// Finds the cell array that a filter was told to process, null if none was set. Returns what is
/// wrong with it, or "". `find` fetches the array of a filter that names none.
std::string findCellArray(vtkAlgorithm* filter, vtkUnstructuredGrid* grid, int index,
  const std::function<vtkDataArray*(int)>& find, vtkDataArray*& array);

/// The same of a point array.
std::string findPointArray(vtkAlgorithm* filter, vtkUnstructuredGrid* grid, int index,
  const std::function<vtkDataArray*(int)>& find, vtkDataArray*& array);

/// Makes `body` of the grid and its point array `Fixed`, and factorises it. Returns what is wrong,
/// or "". `memory` (MiB): what the factorisation takes, also where that is refused. If
/// `goOn(fraction of the work)` returns false it ends at once, and `body` must not be used.
std::string factoriseBody(vtkUnstructuredGrid* grid, const FactorRequest& request,
  const std::function<bool(double)>& goOn, ElasticBody& body, double& memory, bool& ended);
} // namespace palpate

#endif
