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
/// Interpolates the errors at the samples of a curve to a depth (mm). The interpolation is linear
/// in √δ between samples and constant below the first sample. Returns NaN beyond the range (mm).
PALPATERESPONSE_EXPORT double errorBetween(
  const float* errors, int samples, double range, double depth);

/// Access to the estimated relative errors in the array Error of a response.
class PALPATERESPONSE_EXPORT StoredError
{
public:
  /// `body` must outlive this object.
  StoredError(vtkPolyData* body, const std::string& responseName);

  bool isKept() const { return this->Errors != nullptr; }
  /// Error of a point's force at a depth (mm). NaN if the response stores no error, or beyond the
  /// range.
  double at(vtkIdType point, double depth) const;
  /// Error of the force at a place on a triangle. `cell`: the triangle; `point`: a point on it, mm.
  double at(vtkIdType cell, const double* point, double depth) const;

private:
  vtkPolyData* Body;
  vtkFloatArray* Errors;
  vtkFloatArray* Range;
};

/// Adds the array RelativeError (double) to tips with contacts (ContactCell, ContactPoint,
/// Deflection). It is the error of the force on each tip, 0 without contact, NaN if unknown. Adds
/// nothing if the response stores no error. `others` is the error due to interacting contacts, one
/// number per tip, or empty. It is added to RelativeError.
PALPATERESPONSE_EXPORT void addContactErrors(vtkPolyData* body, const std::string& responseName,
  vtkPolyData* tips, const std::vector<double>& others = {});

/// Returns the error as a text that follows a force: " ± 4 %". From 99.5 % upward, the text says
/// that the error has no bound. Returns "" for NaN.
PALPATERESPONSE_EXPORT std::string errorInWords(double relativeError);
} // namespace palpate

#endif
