// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ReplacedCurves_h
#define palpate_ReplacedCurves_h

#include "palpateResponseModule.h"

#include <string>
#include <vector>

class vtkPolyData;

/// Functions of the filters that replace a response by another form of it.
namespace palpate
{
/// Shallow copy with a separate list of field arrays.
PALPATERESPONSE_EXPORT void copyWithOwnFields(vtkPolyData* from, vtkPolyData* to);
/// Removes the curves of a response, in either form; the rest of it stays.
PALPATERESPONSE_EXPORT void removeCurves(vtkPolyData* body, const std::string& name);
/// Attaches values where the contract places the array, in place of one of the same name.
PALPATERESPONSE_EXPORT void addFloats(vtkPolyData* body, const std::string& name,
  ResponseArray which, int components, const std::vector<float>& values);
/// Attaches a text as a field array, in place of one of the same name.
PALPATERESPONSE_EXPORT void addText(
  vtkPolyData* body, const std::string& name, const std::string& text);
} // namespace palpate

#endif
