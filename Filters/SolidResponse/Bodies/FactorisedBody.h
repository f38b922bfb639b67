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
  ElasticMaterial material;        ///< constants, used where there is no array
  vtkDataArray* young = nullptr;   ///< Young's modulus per cell, MPa; null: the constant
  vtkDataArray* poisson = nullptr; ///< Poisson's ratio per cell; null: the constant
  int solver = 0;                  ///< a StiffnessFactor::Kind
  double memoryLimit = 0.0;        ///< MiB; 0: nine tenths of the available memory
};

/// Whether the elements allow this Poisson's ratio: 0 to LargestPoissonRatio.
bool isElementRatio(double ratio);

/// Returns "", or a message that names the wrong property of a request.
std::string checkFactorRequest(const FactorRequest& request);

/// Number of bytes that may be used: the limit (given in MiB), or nine tenths of the memory
/// available now if the limit is 0.
double allowedMemory(double memoryLimit);

/// Finds the cell array that is set as the filter's array to process; null if none is set. `find`
/// returns the array if no name is set. Returns "", or a message about the fault.
std::string findCellArray(vtkAlgorithm* filter, vtkUnstructuredGrid* grid, int index,
  const std::function<vtkDataArray*(int)>& find, vtkDataArray*& array);

/// As findCellArray, for a point array.
std::string findPointArray(vtkAlgorithm* filter, vtkUnstructuredGrid* grid, int index,
  const std::function<vtkDataArray*(int)>& find, vtkDataArray*& array);

/// Makes `body` from the grid and its point array `Fixed` and factorises it. Returns "", or a
/// message about the fault. `memory` (MiB): memory of the factorisation, also set if it is refused.
/// If `goOn(fraction of the work)` returns false the function ends at once and sets `ended`; `body`
/// must then not be used.
std::string factoriseBody(vtkUnstructuredGrid* grid, const FactorRequest& request,
  const std::function<bool(double)>& goOn, ElasticBody& body, double& memory, bool& ended);
} // namespace palpate

#endif
