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
  ElasticMaterial material; ///< material constants, used if there is no array
  /// Young's modulus per cell, MPa; if it is null, the constant is used.
  vtkDataArray* young = nullptr;
  /// Poisson's ratio per cell; if it is null, the constant is used.
  vtkDataArray* poisson = nullptr;
  int solver = 0;           ///< solver, as a value of StiffnessFactor::Kind
  double memoryLimit = 0.0; ///< MiB; 0 allows nine tenths of the available memory
};

/// Returns whether the elements allow this Poisson's ratio, which must be from 0 to
/// LargestPoissonRatio.
bool isElementRatio(double ratio);

/// Returns "", or an error message that names the invalid property of a request.
std::string checkFactorRequest(const FactorRequest& request);

/// Returns the number of bytes that may be used: `memoryLimit` (MiB) or, if it is 0, nine tenths of
/// the memory that is available at the time of the call.
double allowedMemory(double memoryLimit);

/// Finds the cell array that is set as the filter's array to process `index`. `array` is null if
/// none is set. `find` returns the array if no name is set. Returns "" or an error message.
std::string findCellArray(vtkAlgorithm* filter, vtkUnstructuredGrid* grid, int index,
  const std::function<vtkDataArray*(int)>& find, vtkDataArray*& array);

/// Same as findCellArray, for a point array.
std::string findPointArray(vtkAlgorithm* filter, vtkUnstructuredGrid* grid, int index,
  const std::function<vtkDataArray*(int)>& find, vtkDataArray*& array);

/// Creates `body` from the grid and its point array `Fixed`, and factorises it. Returns "" or an
/// error message. `memory` receives the memory of the factorisation, MiB, also if it is refused. If
/// `goOn(fraction of the work)` returns false, the function returns immediately and sets `ended`.
/// In this case `body` must not be used.
std::string factoriseBody(vtkUnstructuredGrid* grid, const FactorRequest& request,
  const std::function<bool(double)>& goOn, ElasticBody& body, double& memory, bool& ended);
} // namespace palpate

#endif
