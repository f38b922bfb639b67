// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * The arrays of a response for the interaction of contacts on its body: Coupling, CouplingModulus,
 * CouplingThickness, CouplingModes of Contact/ResponseContract.h. Without them contacts do not
 * interact.
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

/// Checks that contacts on a body with this material and these arrays can be coupled. Returns "" or
/// an error message.
std::string checkCouples(const BodyMaterial& material, vtkPolyData* body);

/// Attaches the arrays to a body that has passed checkCouples. Replaces existing ones.
void attachCoupling(const BodyMaterial& material, const std::string& name, vtkPolyData* output);

/// Attaches the arrays that store `terms`.
PALPATERESPONSE_EXPORT void describeCoupling(
  vtkPolyData* body, const std::string& name, const CouplingTerms& terms);

/// Fills arrays.coupling with views. The number of points must already be set. Leaves it unchanged
/// if the body has no coupling. Returns false and an error that names array and number if an array
/// is invalid.
bool viewCoupling(
  vtkPolyData* body, const std::string& name, ResponseArrays& arrays, std::string& error);
} // namespace palpate

#endif
