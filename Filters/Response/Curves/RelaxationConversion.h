// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * The arrays of a response by which its body relaxes: RelaxationStrength, RelaxationTime,
 * LocalRelaxation, ElasticCompliance of Contact/ResponseContract.h. With them the curves of the
 * response are its slow part; without them nothing relaxes.
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
/// The series of a response, of no branch where nothing relaxes. Field arrays of k values, as k
/// tuples or as one. False, and an error that names array and number, if it is wrong.
PALPATERESPONSE_EXPORT bool relaxationOf(
  vtkPolyData* body, const std::string& name, PronySeries& series, std::string& error);

/// Attaches the field arrays RelaxationStrength and RelaxationTime in place of any there were.
PALPATERESPONSE_EXPORT void describeRelaxation(
  vtkPolyData* body, const std::string& name, const PronySeries& series);

/// Fills arrays.relaxation, the rest of `arrays` being set: the series, views of the arrays, and,
/// from the text Tool, exponent and contact radius of the tool at the deepest range. If the tool
/// cannot be read, or not be pressed that deep, the exponent is that of the curves, and the radius
/// 0.
bool viewRelaxation(
  vtkPolyData* body, const std::string& name, ResponseArrays& arrays, std::string& error);
} // namespace palpate

#endif
