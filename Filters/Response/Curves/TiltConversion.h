// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * The arrays of a response for the effect of the tool's tilt on the force: Tilt, TiltDrop,
 * TiltNode, TiltWeight of Contact/ResponseContract.h, the numbers of a TiltTable. Without them the
 * tool counts as upright, whatever its axis.
 */
#ifndef TiltConversion_h
#define TiltConversion_h

#include "palpateResponseModule.h" // For export macro

#include "Contact/ResponseField.h"    // For palpate::ResponseArrays
#include "Mechanics/Tilt/TiltTable.h" // For palpate::TiltTable

#include <string> // For std::string
#include <vector> // For std::vector

class vtkPolyData;

namespace palpate
{
/// Attaches the arrays. Replaces existing ones. `weights`: the weight of each law at each point;
/// empty for a table of one law.
PALPATERESPONSE_EXPORT void describeTilts(vtkPolyData* body, const std::string& name,
  const TiltTable& table, const std::vector<float>& weights);

/// Fills arrays.tilt with views of the arrays, if the body has them. Returns false and an error
/// that names the array and the number if they are invalid.
bool viewTilts(
  vtkPolyData* body, const std::string& name, ResponseArrays& arrays, std::string& error);
} // namespace palpate

#endif
