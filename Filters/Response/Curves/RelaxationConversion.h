// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * The arrays of a response for the relaxation of its body: RelaxationStrength, RelaxationTime,
 * LocalRelaxation, ElasticCompliance of Contact/ResponseContract.h. With them the curves of the
 * response are its slow part. Without them the body does not relax.
 */
#ifndef RelaxationConversion_h
#define RelaxationConversion_h

#include "palpateResponseModule.h" // For export macro

#include "Contact/ResponseField.h"            // For palpate::ResponseArrays
#include "Mechanics/Relaxation/PronySeries.h" // For palpate::PronySeries

#include <string> // For std::string

class vtkPolyData;

namespace palpate
{
/// The series of a response; without branches if the body does not relax. A field array has k
/// values, as k tuples or as one tuple. Returns false and an error that names array and number if
/// an array is invalid.
PALPATERESPONSE_EXPORT bool relaxationOf(
  vtkPolyData* body, const std::string& name, PronySeries& series, std::string& error);

/// Attaches the field arrays RelaxationStrength and RelaxationTime. Replaces existing ones.
PALPATERESPONSE_EXPORT void describeRelaxation(
  vtkPolyData* body, const std::string& name, const PronySeries& series);

/// Fills arrays.relaxation; the rest of `arrays` must be set. Sets the series, views of the arrays
/// and, from the text Tool, exponent and contact radius of the tool at the largest range. If the
/// tool cannot be read, or cannot be pressed to that depth, the exponent is that of the curves and
/// the radius is 0.
bool viewRelaxation(
  vtkPolyData* body, const std::string& name, ResponseArrays& arrays, std::string& error);
} // namespace palpate

#endif
