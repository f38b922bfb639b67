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
/// Returns the error at a depth (mm), interpolated between the errors at the samples of a curve.
/// The interpolation is linear in √δ between samples and constant below the first sample. Returns
/// NaN if the depth is beyond the range (mm).
PALPATERESPONSE_EXPORT double errorBetween(
  const float* errors, int samples, double range, double depth);

/// Access to the estimated relative errors in the array Error of a response.
class PALPATERESPONSE_EXPORT StoredError
{
public:
  /// `body` must outlive this object.
  StoredError(vtkPolyData* body, const std::string& responseName);

  bool isKept() const { return this->Errors != nullptr; }
  /// Returns the error of a point's force at a depth (mm). Returns NaN if the response stores no
  /// error, or if the depth is beyond the range.
  double at(vtkIdType point, double depth) const;
  /// Returns the error of the force at `point` (mm) on the triangle `cell`.
  double at(vtkIdType cell, const double* point, double depth) const;

private:
  vtkPolyData* Body;
  vtkFloatArray* Errors;
  vtkFloatArray* Range;
};

/// Adds the array RelativeError (double) to tips with contacts (ContactCell, ContactPoint,
/// Deflection). RelativeError is the relative error of the force on each tip. It is 0 without
/// contact and NaN if the error is unknown. Adds nothing if the response stores no error. `others`
/// contains the error due to interacting contacts, one number per tip, or is empty. It is added to
/// RelativeError.
PALPATERESPONSE_EXPORT void addContactErrors(vtkPolyData* body, const std::string& responseName,
  vtkPolyData* tips, const std::vector<double>& others = {});

/// Returns the error as a text that follows a force, for example " ± 4 %". If the error is at least
/// 99.5 %, the text states that the error has no bound. Returns "" for NaN.
PALPATERESPONSE_EXPORT std::string errorInWords(double relativeError);
} // namespace palpate

#endif
