// SPDX-License-Identifier: BSD-3-Clause
#ifndef StoredError_h
#define StoredError_h

#include "palpateResponseModule.h" // For export macro

#include "vtkType.h"

#include <string>
#include <vector>

class vtkFloatArray;
class vtkPolyData;

namespace palpate
{
/// The error at a depth (mm), from the errors at the samples of a curve. Linear in √δ between
/// samples, constant below the first sample, NaN beyond the range (mm).
PALPATERESPONSE_EXPORT double errorBetween(
  const float* errors, int samples, double range, double depth);

/// The estimated relative errors in the array Error of a response.
class PALPATERESPONSE_EXPORT StoredError
{
public:
  /// `body` must outlive this object.
  StoredError(vtkPolyData* body, const std::string& responseName);

  bool isKept() const { return this->Errors != nullptr; }
  /// Error of a point's force at a depth (mm). NaN if the response stores no error, or beyond the
  /// range.
  double at(vtkIdType point, double depth) const;
  /// Error of the force at a place on a triangle, given by its cell and a point on it.
  double at(vtkIdType cell, const double* point, double depth) const;

private:
  vtkPolyData* Body;
  vtkFloatArray* Errors;
  vtkFloatArray* Range;
};

/// Adds the array RelativeError (double) to tips with contacts (ContactCell, ContactPoint,
/// Deflection): the error of the force on each tip, 0 without contact, NaN if unknown. Adds nothing
/// if the response stores no error. `others` (one number per tip, or empty) is added to it: the
/// error due to contacts that act on one another.
PALPATERESPONSE_EXPORT void addContactErrors(vtkPolyData* body, const std::string& responseName,
  vtkPolyData* tips, const std::vector<double>& others = {});

/// The error as a text that follows a force: " ± 4 %". At 100 % or more, the text says that the
/// force is unknown; "" for NaN.
PALPATERESPONSE_EXPORT std::string errorInWords(double relativeError);
} // namespace palpate

#endif
