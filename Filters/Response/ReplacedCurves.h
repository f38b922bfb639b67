// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ReplacedCurves_h
#define palpate_ReplacedCurves_h

#include "palpateResponseModule.h"

#include <string>
#include <vector>

class vtkPolyData;

/// Functions for filters that replace a response by another form.
namespace palpate
{
/// Makes a shallow copy of a body. The copy has its own list of field arrays.
PALPATERESPONSE_EXPORT void copyWithOwnFields(vtkPolyData* from, vtkPolyData* to);
/// Removes the curves of a response, in either form. All other arrays remain.
PALPATERESPONSE_EXPORT void removeCurves(vtkPolyData* body, const std::string& name);
/// Attaches values as point data or field data, as the contract defines. Replaces an array of the
/// same name.
PALPATERESPONSE_EXPORT void addFloats(vtkPolyData* body, const std::string& name,
  ResponseArray which, int components, const std::vector<float>& values);
/// Attaches a text as a field array. Replaces an array of the same name.
PALPATERESPONSE_EXPORT void addText(
  vtkPolyData* body, const std::string& name, ResponseArray which, const std::string& text);
} // namespace palpate

#endif
