// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * The arrays of a response by which contacts on its body feel one another: Coupling,
 * CouplingModulus, CouplingThickness, CouplingModes of Contact/ResponseContract.h. Without them
 * each contact is alone.
 */
#ifndef CouplingConversion_h
#define CouplingConversion_h

#include "palpateResponseModule.h" // For export macro

#include "Contact/ResponseField.h" // For palpate::ResponseArrays

#include <string> // For std::string

class vtkPolyData;

namespace palpate
{
class BodyMaterial;

/// The point array of a body with its motion by finite elements (vtkElasticCompliance).
constexpr const char* CouplingModesName = "CouplingModes";

/// Why contacts on a body of this material, with these arrays, cannot be coupled; or "".
std::string checkCouples(const BodyMaterial& material, vtkPolyData* body);

/// Attaches the arrays of a body that has passed checkCouples, in place of any there were.
void attachCoupling(const BodyMaterial& material, const std::string& name, vtkPolyData* output);

/// Attaches the arrays of these terms.
PALPATERESPONSE_EXPORT void describeCoupling(
  vtkPolyData* body, const std::string& name, const CouplingTerms& terms);

/// Fills arrays.coupling with views, the number of points being set already. Leaves it unchanged
/// where there is none. False, and an error that names array and number, if it is wrong.
bool viewCoupling(
  vtkPolyData* body, const std::string& name, ResponseArrays& arrays, std::string& error);
} // namespace palpate

#endif
