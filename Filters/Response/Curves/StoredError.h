// SPDX-License-Identifier: BSD-3-Clause
#ifndef StoredError_h
#define StoredError_h

#include "palpateResponseModule.h" // For export macro

#include "vtkType.h"

#include <string>

class vtkFloatArray;
class vtkPolyData;

namespace palpate
{
/// The error at a depth (mm), from those at the samples of a curve: linear in √δ between samples,
/// constant below the first, NaN beyond the range (mm).
PALPATERESPONSE_EXPORT double errorBetween(
  const float* errors, int samples, double range, double depth);

/// The estimated relative errors that a response keeps in its array Error.
class PALPATERESPONSE_EXPORT StoredError
{
public:
  /// `body` must outlive this.
  StoredError(vtkPolyData* body, const std::string& responseName);

  bool isKept() const { return this->Errors != nullptr; }
  /// Of a point's force at a depth (mm). NaN where none is kept, or beyond the range.
  double at(vtkIdType point, double depth) const;
  /// Of the force at a place on a triangle, given by its cell and a point on it.
  double at(vtkIdType cell, const double* point, double depth) const;

private:
  vtkPolyData* Body;
  vtkFloatArray* Errors;
  vtkFloatArray* Range;
};

/// Adds to tips that were touched (ContactCell, ContactPoint, Deflection) the array RelativeError
/// (double): of the force on each, 0 without contact, NaN where it is not known. Adds nothing if
/// the response keeps no error.
PALPATERESPONSE_EXPORT void addContactErrors(
  vtkPolyData* body, const std::string& responseName, vtkPolyData* tips);

/// The text to write behind a force: " ± 4 %"; from 100 % on, that nothing is known; "" for NaN.
PALPATERESPONSE_EXPORT std::string errorInWords(double relativeError);
} // namespace palpate

#endif
