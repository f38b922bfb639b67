// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * The arrays by which a response tells how its body relaxes: RelaxationStrength, RelaxationTime,
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

/// Fills arrays.relaxation, the rest of `arrays` being there: series, arrays where they lie, and,
/// from the text Tool, exponent and contact radius of the tool at the deepest range. Of a tool that
/// cannot be read, or not be pressed as deep, the exponent is that of the curves, the radius 0.
bool viewRelaxation(
  vtkPolyData* body, const std::string& name, ResponseArrays& arrays, std::string& error);
} // namespace palpate

#endif
